# A third of the time that a file took to compile went into reading Eigen, the standard library and
# GoogleTest; they are read once per group of targets that are compiled alike. Not for app/: with
# CLI11 and JSON in them, precompiled headers cost more than they save. The sources still include
# what they use, which a build with -DEMBERLEAF_PRECOMPILE=OFF proves (the asan preset).
option(EMBERLEAF_PRECOMPILE "Precompile the headers of libraries" ON)

set(EMBER_COMMON_HEADERS <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <memory>
    <optional> <span> <sstream> <string> <string_view> <vector> <Eigen/Core> <Eigen/Geometry>)

# ember_precompile(<target> [<header>...])  the common headers and these
function(ember_precompile target)
    if(EMBERLEAF_PRECOMPILE)
        target_precompile_headers(${target} PRIVATE ${EMBER_COMMON_HEADERS} ${ARGN})
    endif()
endfunction()

# ember_precompile_like(<target> <other>)  those of a target that is compiled with the same options
function(ember_precompile_like target other)
    if(EMBERLEAF_PRECOMPILE)
        target_precompile_headers(${target} REUSE_FROM ${other})
    endif()
endfunction()
