# A Debian package: cmake --preset release && cmake --build --preset release, then, in
# build/release, cpack -G DEB.
#
# Packing takes what is built and builds nothing.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY TRUE)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME emberleaf)
set(CPACK_PACKAGE_CONTACT "The emberleaf authors <emberleaf@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulates and draws burning paper")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES TRUE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Burning paper at the level of its fibres: in a window, or
 off-screen as pictures, films and moving geometry.")
# What the program is linked with, dpkg-shlibdeps finds; this is what it opens at run time.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS TRUE)
set(CPACK_DEBIAN_PACKAGE_DEPENDS libosmesa6)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1, libegl1, libgl1-mesa-dri, ffmpeg, fonts-inter")
include(CPack)
