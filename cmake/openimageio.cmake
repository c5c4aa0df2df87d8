# OpenImageIO::OpenImageIO. Only the module cuesta_images links it: it loads 261 shared libraries.
#
# Through pkg-config, because Debian 12's CMake package cannot be used as installed: it names the programs of
# openimageio-tools and /usr/include/opencv4, and CMake refuses files and include paths that do not exist.
pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET GLOBAL OpenImageIO Imath)
add_library(OpenImageIO::OpenImageIO ALIAS PkgConfig::OpenImageIO)
set(OpenImageIO_VERSION "${OpenImageIO_OpenImageIO_VERSION}")
