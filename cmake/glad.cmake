# Generates the OpenGL 3.3 core loader at configure time; target ember_glad.
find_program(EMBERLEAF_GLAD NAMES glad PATHS /usr/bin NO_DEFAULT_PATH)
ember_require(EMBERLEAF_GLAD python3-glad)
set(EMBER_GLAD_DIR ${PROJECT_BINARY_DIR}/glad)
if(NOT EXISTS ${EMBER_GLAD_DIR}/src/gl.c)
    execute_process(
        COMMAND ${EMBERLEAF_GLAD} --reproducible --quiet --api gl:core=3.3 --extensions
                GL_KHR_debug --out-path ${EMBER_GLAD_DIR} c
        RESULT_VARIABLE EMBER_GLAD_RESULT OUTPUT_QUIET ERROR_VARIABLE EMBER_GLAD_ERROR)
    if(NOT EMBER_GLAD_RESULT EQUAL 0)
        message(FATAL_ERROR "glad failed: ${EMBER_GLAD_ERROR}")
    endif()
endif()
add_library(ember_glad STATIC ${EMBER_GLAD_DIR}/src/gl.c)
target_include_directories(ember_glad SYSTEM PUBLIC ${EMBER_GLAD_DIR}/include)
