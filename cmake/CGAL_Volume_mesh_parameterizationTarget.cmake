# The target CGAL::Volume_mesh_parameterization, in this build and installed.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# A folder of its own: one header stands in for CGAL's header of the same name and must never replace it.
set(_include_dir ${CMAKE_INSTALL_INCLUDEDIR}/${PROJECT_NAME})
set(_config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/${PROJECT_NAME})

add_library(${PROJECT_NAME} INTERFACE)
add_library(CGAL::Volume_mesh_parameterization ALIAS ${PROJECT_NAME})
set_target_properties(${PROJECT_NAME} PROPERTIES EXPORT_NAME Volume_mesh_parameterization)
target_compile_features(${PROJECT_NAME} INTERFACE cxx_std_17)
target_include_directories(${PROJECT_NAME} INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
  $<INSTALL_INTERFACE:${_include_dir}>)
# The optional parts are decided where the headers are compiled, not where they were installed.
target_link_libraries(${PROJECT_NAME} INTERFACE
  CGAL::CGAL CGAL::Eigen3_support
  $<TARGET_NAME_IF_EXISTS:CGAL::TBB_support>
  $<TARGET_NAME_IF_EXISTS:CGAL::CHOLMOD_support>)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${_include_dir})
install(TARGETS ${PROJECT_NAME} EXPORT ${PROJECT_NAME}Targets)
install(EXPORT ${PROJECT_NAME}Targets NAMESPACE CGAL:: DESTINATION ${_config_dir})

write_basic_package_version_file(${PROJECT_BINARY_DIR}/${PROJECT_NAME}ConfigVersion.cmake
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES
  ${PROJECT_BINARY_DIR}/${PROJECT_NAME}ConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/cmake/${PROJECT_NAME}Config.cmake
  ${PROJECT_SOURCE_DIR}/cmake/${PROJECT_NAME}Dependencies.cmake
  ${PROJECT_SOURCE_DIR}/cmake/CGAL_CHOLMOD_support.cmake
  DESTINATION ${_config_dir})
