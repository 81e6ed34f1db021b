# The stb headers and their implementation, compiled once; target ember_stb.
find_path(EMBERLEAF_STB stb_image.h PATH_SUFFIXES stb)
ember_require(EMBERLEAF_STB libstb-dev)
add_library(ember_stb STATIC ${CMAKE_CURRENT_LIST_DIR}/stb.cpp)
# not ours to warn about
set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/stb.cpp PROPERTIES COMPILE_OPTIONS "-w")
target_include_directories(ember_stb SYSTEM PUBLIC ${EMBERLEAF_STB})
