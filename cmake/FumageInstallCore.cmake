# The library as a CMake package:  find_package(Fumage 0.1)  target_link_libraries(... Fumage::fumage_core)  #include <fumage/...>
include(CMakePackageConfigHelpers)

set(FUMAGE_PACKAGE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/Fumage)
install(TARGETS fumage_core EXPORT FumageTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
install(DIRECTORY ${PROJECT_BINARY_DIR}/include/fumage DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
# The very shaders that the editor draws sprites with.
set(FUMAGE_GLSL_FOLDER ${CMAKE_INSTALL_DATADIR}/fumage/glsl)
install(FILES ${PROJECT_SOURCE_DIR}/resources/shaders/sprite.vert ${PROJECT_SOURCE_DIR}/resources/shaders/sprite.frag DESTINATION ${FUMAGE_GLSL_FOLDER} COMPONENT dev)
install(EXPORT FumageTargets NAMESPACE Fumage:: DESTINATION ${FUMAGE_PACKAGE_FOLDER} COMPONENT dev)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/FumageConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/FumageConfig.cmake
    INSTALL_DESTINATION ${FUMAGE_PACKAGE_FOLDER} PATH_VARS FUMAGE_GLSL_FOLDER)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/FumageConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/FumageConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/FumageConfigVersion.cmake
    DESTINATION ${FUMAGE_PACKAGE_FOLDER} COMPONENT dev)
fumage_documents(libfumage-dev dev parameters.md docs/games.md)
