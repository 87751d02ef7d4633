# The target CGAL::Polycube_meshing_3, in this build and installed, as that of the package on which it depends.
if(NOT CGAL_Polycube_meshing_3)
  return()
endif()
set(_package CGAL_Polycube_meshing_3)
set(_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/${_package})

add_library(${_package} INTERFACE)
add_library(CGAL::Polycube_meshing_3 ALIAS ${_package})
set_target_properties(${_package} PROPERTIES EXPORT_NAME Polycube_meshing_3)
target_link_libraries(${_package} INTERFACE CGAL::Volume_mesh_parameterization)

if(${PROJECT_NAME}_ENGINE)
  file(CONFIGURE OUTPUT polycube_engine.cpp CONTENT [[
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/find_hexahedra_3_impl.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/map_to_polycube_3_impl.h>
]] @ONLY)
  CGAL_Volume_mesh_parameterization_add_engine(${_package} ${CMAKE_CURRENT_BINARY_DIR}/polycube_engine.cpp)
  target_link_libraries(${_package}_engine PUBLIC CGAL::Volume_mesh_parameterization_engine)
endif()

if(NOT ${PROJECT_NAME}_INSTALL)
  return()
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${_include_dir} FILES_MATCHING
  REGEX "Polycube_meshing_3(/.*)?\\.h$" PATTERN "Volume_mesh_parameterization" EXCLUDE PATTERN "STL_Extension" EXCLUDE)
install(TARGETS ${_package} EXPORT ${_package}Targets)
install(EXPORT ${_package}Targets NAMESPACE CGAL:: DESTINATION ${_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/${_package}ConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/${_package}ConfigVersion.cmake ${PROJECT_SOURCE_DIR}/cmake/${_package}Config.cmake
  DESTINATION ${_package_dir})
