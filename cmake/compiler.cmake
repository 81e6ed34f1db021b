# Everything that all of our targets share is on one interface target, ember_options.
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_EXTENSIONS OFF)

add_library(ember_options INTERFACE)
target_compile_features(ember_options INTERFACE cxx_std_20)
target_include_directories(ember_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(ember_options INTERFACE
    # One rounding per operation, on every processor: a fused multiply-add would change the bits.
    -ffp-contract=off
    # sqrt() never reads errno and no trap handler is installed by the library; neither changes a
    # value, and without these two the force loops are not vectorised.
    -fno-math-errno -fno-trapping-math
    # GCC 12 sees overlaps in std::string's operator+ that are not there (its bug 105651)
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wdouble-promotion)
if(EMBERLEAF_WARNINGS_AS_ERRORS)
    target_compile_options(ember_options INTERFACE -Werror)
endif()
if(EMBERLEAF_SANITIZE)
    target_compile_options(ember_options INTERFACE -fsanitize=${EMBERLEAF_SANITIZE}
                           -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(ember_options INTERFACE -fsanitize=${EMBERLEAF_SANITIZE})
endif()
