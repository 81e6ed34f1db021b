# ember_require(<what> <package>): stops with the name of the Debian package when <what> is not found.
macro(ember_require what package)
    if(NOT ${what})
        message(FATAL_ERROR "${what} not found: sudo apt install ${package}")
    endif()
endmacro()
