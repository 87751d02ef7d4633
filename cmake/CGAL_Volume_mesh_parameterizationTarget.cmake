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
if(MSVC)
  target_include_directories(${PROJECT_NAME} INTERFACE $<BUILD_INTERFACE:${CGAL_parameters_interface_folder}>)
endif()
# The optional parts are decided where the headers are compiled, not where they were installed.
target_link_libraries(${PROJECT_NAME} INTERFACE
  CGAL::CGAL CGAL::Eigen3_support
  $<TARGET_NAME_IF_EXISTS:CGAL::TBB_support>
  $<TARGET_NAME_IF_EXISTS:CGAL::CHOLMOD_support>
  $<TARGET_NAME_IF_EXISTS:CGAL::VTU_compression_support>)

# Adds the target with the engine of a package, of the sources given. Who configures and installs gets the engine, too.
function(CGAL_Volume_mesh_parameterization_add_engine package)
  string(REPLACE CGAL_ "" name ${package})
  string(TOUPPER ${package} macro)
  add_library(${package}_engine STATIC ${ARGN})
  add_library(CGAL::${name}_engine ALIAS ${package}_engine)
  set_target_properties(${package}_engine PROPERTIES EXPORT_NAME ${name}_engine
    POSITION_INDEPENDENT_CODE ON) # shared libraries link it, too
  target_link_libraries(${package}_engine PUBLIC ${package})
  target_compile_definitions(${package}_engine PUBLIC ${macro}_COMPILED_ENGINE)
  if(${PROJECT_NAME}_NATIVE)
    target_compile_options(${package}_engine PRIVATE -march=native)
  endif()
  if(NOT CMAKE_CXX_FLAGS MATCHES "(^| )[-/]O") # without a build type, the engine would be a hundred times slower
    target_compile_options(${package}_engine PRIVATE $<$<NOT:$<BOOL:$<CONFIG>>>:-O2>)
  endif()
  if(NOT ${PROJECT_NAME}_INSTALL)
    set_target_properties(${package}_engine PROPERTIES EXCLUDE_FROM_ALL ON)
    return()
  endif()
  install(CODE "if(NOT EXISTS \"$<TARGET_FILE:${package}_engine>\")
    execute_process(COMMAND \"${CMAKE_COMMAND}\" --build \"${CMAKE_BINARY_DIR}\" --target ${package}_engine
      --config \"\${CMAKE_INSTALL_CONFIG_NAME}\" COMMAND_ERROR_IS_FATAL ANY)
  endif()")
  install(TARGETS ${package}_engine EXPORT ${package}Targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
endfunction()

# The target with the engine compiled once, for those who have many units or build often. It agrees with units of any flags:
# no type that both know depends on them, so its users learn nothing but the macro.
if(${PROJECT_NAME}_ENGINE)
  file(CONFIGURE OUTPUT engine.cpp CONTENT [[
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/map_to_boundaries_3_impl.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Numbered_surface_3_impl.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Body_3_impl.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Triangulated_surface_3_impl.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/parameterize_body_3_impl.h>
#include <CGAL/Volume_mesh_parameterization/internal/Solvers/Conjugate_gradient_3_impl.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/parallel_impl.h>
namespace CGAL::Volume_mesh_parameterization {
template std::unique_ptr<internal::Conjugate_gradient_3<float> > internal::make_conjugate_gradient_3(bool, int);
template std::unique_ptr<internal::Conjugate_gradient_3<double> > internal::make_conjugate_gradient_3(bool, int);
template class internal::Linear_solver_of<Conjugate_gradient_solver_traits_3<Sequential_tag> >;
#ifdef CGAL_LINKED_WITH_TBB
template class internal::Linear_solver_of<Conjugate_gradient_solver_traits_3<Parallel_tag> >;
#endif
const internal::Cell_energy_3& internal::cell_energy_3(const Stretch_energy_3& energy)
{
  static const Cell_energy_of<Stretch_energy_3> result(energy);
  return result;
}
void internal::fail_precondition(const char* message, const char* file, int line) { precondition_fail("", file, line, message); }
}
]] @ONLY)
  file(CONFIGURE OUTPUT boundary_engine.cpp CONTENT [[
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Box/map_to_box_3_impl.h>
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/Sphere/map_to_sphere_3_impl.h>
namespace CGAL::Volume_mesh_parameterization::internal {
template Error_code map_to_sphere_3(const Numbered_surface_3& surface, const Landmarks_3& landmarks,
                                    std::vector<Vector_3>& images, const Budget& budget);
}
]] @ONLY)
  file(CONFIGURE OUTPUT surface_engine.cpp CONTENT [[
#include <CGAL/Volume_mesh_parameterization/internal/IO/read_surface_impl.h>
#include <CGAL/Volume_mesh_parameterization/internal/IO/repair_surface_impl.h>
]] @ONLY)
  # The sparse solvers allocate memory by the flags of a unit, as all of Eigen does. By another name, they are the engine's own.
  file(CONFIGURE OUTPUT sparse_systems.cpp CONTENT [[
#define Eigen Eigen_of_Volume_mesh_parameterization
#include <CGAL/Volume_mesh_parameterization/internal/Boundary/sparse_systems_impl.h>
#include <CGAL/Volume_mesh_parameterization/internal/Solvers/Direct_solver_3_impl.h>
]] @ONLY)
  CGAL_Volume_mesh_parameterization_add_engine(${PROJECT_NAME} ${CMAKE_CURRENT_BINARY_DIR}/engine.cpp
    ${CMAKE_CURRENT_BINARY_DIR}/boundary_engine.cpp ${CMAKE_CURRENT_BINARY_DIR}/surface_engine.cpp
    ${CMAKE_CURRENT_BINARY_DIR}/sparse_systems.cpp)
  # The package's configuration asks for what the engine was built with.
  if(TARGET CGAL::TBB_support)
    set_target_properties(${PROJECT_NAME}_engine PROPERTIES
      IS_BUILT_WITH_TBB TRUE EXPORT_PROPERTIES IS_BUILT_WITH_TBB)
  endif()
endif()

if(NOT ${PROJECT_NAME}_INSTALL)
  return()
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${_include_dir} PATTERN "Polycube_meshing_3*" EXCLUDE)
install(TARGETS ${PROJECT_NAME} EXPORT ${PROJECT_NAME}Targets)
install(EXPORT ${PROJECT_NAME}Targets NAMESPACE CGAL:: DESTINATION ${_config_dir})

write_basic_package_version_file(${PROJECT_BINARY_DIR}/${PROJECT_NAME}ConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/${PROJECT_NAME}ConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/cmake/${PROJECT_NAME}Config.cmake
  ${PROJECT_SOURCE_DIR}/cmake/${PROJECT_NAME}Dependencies.cmake
  ${PROJECT_SOURCE_DIR}/cmake/CGAL_CHOLMOD_support.cmake
  ${PROJECT_SOURCE_DIR}/cmake/CGAL_PETSc_support.cmake
  ${PROJECT_SOURCE_DIR}/cmake/CGAL_VTU_compression_support.cmake
  DESTINATION ${_config_dir})
