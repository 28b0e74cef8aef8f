# Debian packages, by cpack -G DEB: fumage (the editor), fumage-cli (no Qt, no display), the shared library for programs in C, named after its soname, and
# libfumage-dev. What the programs link to is
# found by dpkg-shlibdeps; ./dev package builds them and tries them.
set(CPACK_PACKAGE_NAME fumage)
set(CPACK_PACKAGE_VENDOR "The Fumage developers")
set(CPACK_PACKAGE_CONTACT ${FUMAGE_MAINTAINER})
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)

set(CPACK_COMPONENTS_ALL dev)
if(FUMAGE_BUILD_SHARED)
    list(APPEND CPACK_COMPONENTS_ALL library)
endif()
if(FUMAGE_BUILD_CLI)
    list(APPEND CPACK_COMPONENTS_ALL cli)
endif()
if(FUMAGE_BUILD_UI)
    list(APPEND CPACK_COMPONENTS_ALL editor)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(CPACK_DEBIAN_CLI_PACKAGE_NAME fumage-cli)
set(CPACK_DEBIAN_CLI_PACKAGE_SECTION graphics)
# The first line of all packages; lintian wants no article.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Smoke for games and motion graphics")
set(CPACK_COMPONENT_CLI_DESCRIPTION "Smoke for games and motion graphics, from the command line
Renders presets of smoke to pictures, image sequences and flipbooks and bakes
seamless noise, without a display or a graphics card. Every frame is the same
picture on every machine.")

set(CPACK_DEBIAN_EDITOR_PACKAGE_NAME fumage)
set(CPACK_DEBIAN_EDITOR_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_EDITOR_PACKAGE_RECOMMENDS "fumage-cli, qt6-translations-l10n")
set(CPACK_DEBIAN_EDITOR_PACKAGE_SUGGESTS qt6-wayland)
set(CPACK_COMPONENT_EDITOR_DESCRIPTION "Editor for smoke, for games and motion graphics
Move a few sliders, see the smoke change at once, and take it away as image
sequences, flipbooks, textures or particles.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libfumage-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(FUMAGE_LIBRARY_PACKAGE libfumage${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME ${FUMAGE_LIBRARY_PACKAGE})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "Library of smoke that steps with a game
The functions of fumage.h, for programs in C and in what else can call it:
smoke that follows a moving emitter, takes parameters as it runs and keeps a
budget of time.")
# Which version those need who link to it, before 1.0 this one; and that the cache of libraries is to be made anew.
file(WRITE ${CMAKE_BINARY_DIR}/debian/shlibs "libfumage ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} ${FUMAGE_LIBRARY_PACKAGE} (= ${PROJECT_VERSION})\n")
file(WRITE ${CMAKE_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
file(CHMOD ${CMAKE_BINARY_DIR}/debian/shlibs ${CMAKE_BINARY_DIR}/debian/triggers PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${CMAKE_BINARY_DIR}/debian/shlibs ${CMAKE_BINARY_DIR}/debian/triggers)

set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "${FUMAGE_LIBRARY_PACKAGE} (= ${PROJECT_VERSION}), libglm-dev, libhwy-dev, libtbb-dev, libpng-dev, libopenexr-dev, nlohmann-json3-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION "Library that makes smoke, for use inside a game
Simulation, noise, lighting and rendering of smoke as a static library with a
CMake package: find_package(Fumage) and Fumage::fumage_core.")

include(CPack)
