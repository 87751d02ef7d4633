// One mistake of a caller, chosen by a macro, which the compiler answers with a sentence of this package.
#ifdef COMPLEX_IS_PERIODIC // CGAL wants its header before all others that mesh
#  include <CGAL/Periodic_3_mesh_triangulation_3.h>
#  include <CGAL/Labeled_mesh_domain_3.h>
#endif

#include <CGAL/Volume_mesh_parameterization/make_parameterizable.h>
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#if defined HEXAHEDRA_OF_A_CONTAINER || defined MAP_OF_A_CONTAINER || defined UNKNOWN_PARAMETER_OF_HEXAHEDRA \
  || defined ENGINE_OF_ONE_PACKAGE
#  include <CGAL/Polycube_meshing_3/make_hexahedral_mesh_3.h>
#elif defined SOLVER_OF_EIGEN
#  include <CGAL/Eigen_solver_traits.h>
#endif

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
namespace params = CGAL::parameters;

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Tr = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<K>;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;
using Vertex_handle = C3t3::Vertex_handle;

struct Own_energy
{
#ifdef ENERGY_OF_NUMBERS
  double value(double, double, double) const { return 0; }
#else
  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>& s) const
  {
    if(s[0] < T(1))
      return T(0);
    return s[0];
  }
#endif

  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>& s) const { return s; }

  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>&) const { return Eigen::Matrix<T, 3, 3>(); }
};

struct Silent_visitor
{
  void after_step(const VMP::Parameterization_step&) {}
};

void call(const C3t3& c3t3, std::unordered_map<Vertex_handle, K::Point_3>& uvw)
{
  const auto uvw_map = VMP::make_vertex_point_map(uvw);
#ifdef TARGETS_ARE_A_FUNCTION
  const auto target = [](const Vertex_handle v) { return v->point(); };
  CGAL::stretch_minimizing_volume_parameterization(c3t3, uvw_map, params::boundary_map(target));
#elif defined TARGETS_ARE_A_CONTAINER
  CGAL::stretch_minimizing_volume_parameterization(c3t3, uvw_map, params::boundary_map(uvw));
#elif defined IMAGES_ARE_A_CONTAINER
  CGAL::stretch_minimizing_volume_parameterization(c3t3, uvw);
#elif defined IMAGES_ARE_NUMBERS
  std::unordered_map<Vertex_handle, double> numbers;
  CGAL::stretch_minimizing_volume_parameterization(c3t3, boost::make_assoc_property_map(numbers));
#elif defined CONSTANT_COMPLEX_IS_REFINED
  CGAL::stretch_minimizing_volume_parameterization(c3t3, uvw_map, params::refinement_mode(VMP::Refinement_mode::HELPFUL));
#elif defined CONSTANT_ARRAYS_ARE_REFINED
  const std::vector<std::array<double, 3> > points;
  const std::vector<std::array<std::size_t, 4> > cells;
  std::vector<std::array<double, 3> > images;
  CGAL::stretch_minimizing_volume_parameterization(points, cells, points, images,
                                                   params::refinement_mode(VMP::Refinement_mode::HELPFUL));
#elif defined IMAGES_ARE_MISSING
  std::vector<std::array<double, 3> > points;
  std::vector<std::array<std::size_t, 4> > cells;
  CGAL::stretch_minimizing_volume_parameterization(points, cells);
#elif defined POINTS_ARE_COLUMNS
  Eigen::Matrix3Xd points, images;
  Eigen::Matrix4Xi cells;
  CGAL::stretch_minimizing_volume_parameterization(points, cells, images);
#elif defined IMAGES_ARE_INTEGERS
  const Eigen::MatrixXd points;
  Eigen::MatrixXi cells, images;
  CGAL::stretch_minimizing_volume_parameterization(points, cells, images);
#elif defined BOUNDARY_IS_GIVEN_TWICE
  CGAL::stretch_minimizing_volume_parameterization(
    c3t3, uvw_map, params::boundary_map(uvw_map).boundary_parameterizer(VMP::Ball_boundary_parameterizer_3()));
#elif defined BOUNDARY_PARAMETERIZER_IS_A_FUNCTION
  CGAL::stretch_minimizing_volume_parameterization(c3t3, uvw_map, params::boundary_parameterizer([](int) { return 0; }));
#elif defined TARGETS_BY_INDICES
  std::unordered_map<std::size_t, K::Point_3> targets;
  CGAL::stretch_minimizing_volume_parameterization(c3t3, uvw_map, params::boundary_map(VMP::make_vertex_point_map(targets)));
#elif defined IMAGES_BY_INDICES
  std::unordered_map<std::size_t, K::Point_3> images;
  CGAL::stretch_minimizing_volume_parameterization(c3t3, VMP::make_vertex_point_map(images));
#elif defined START_BY_INDICES
  std::unordered_map<std::size_t, K::Point_3> start;
  CGAL::stretch_minimizing_volume_parameterization(c3t3, uvw_map, params::initial_map(VMP::make_vertex_point_map(start)));
#elif defined START_IS_A_CONTAINER || defined CONDITIONS_ARE_A_CONTAINER
  const std::vector<std::array<double, 3> > points;
  const std::vector<std::array<std::size_t, 4> > cells;
  std::vector<std::array<double, 3> > images;
#  ifdef START_IS_A_CONTAINER
  CGAL::stretch_minimizing_volume_parameterization(points, cells, points, images, params::initial_map(points));
#  else
  const std::vector<VMP::Vertex_condition_3> conditions(4);
  CGAL::stretch_minimizing_volume_parameterization(points, cells, points, images, params::vertex_condition_map(conditions));
#  endif
#elif defined HEXAHEDRA_OF_A_CONTAINER
  CGAL::Polycube_meshing_3::Hexahedron_soup_3 hexahedra;
  CGAL::Polycube_meshing_3::make_hexahedral_mesh_3(c3t3, uvw, 0.1, hexahedra);
#elif defined MAP_OF_A_CONTAINER
  VMP::Volume_map_3 map(c3t3, uvw);
#elif defined VISITOR_RETURNS_NOTHING
  CGAL::stretch_minimizing_volume_parameterization(c3t3, uvw_map, params::visitor(Silent_visitor()));
#elif defined VISITOR_IS_A_FUNCTION
  CGAL::stretch_minimizing_volume_parameterization(c3t3, uvw_map, params::visitor([](int) { return true; }));
#elif defined ENERGY_OF_NUMBERS || defined ENERGY_BRANCHES
  CGAL::stretch_minimizing_volume_parameterization(c3t3, uvw_map, params::energy(Own_energy()));
#elif defined SOLVER_OF_EIGEN
  CGAL::stretch_minimizing_volume_parameterization(c3t3, uvw_map, params::solver_traits(CGAL::Eigen_solver_traits<>()));
#elif defined TRIANGULATION_IS_MAPPED
  CGAL::stretch_minimizing_volume_parameterization(c3t3.triangulation(), uvw_map);
#elif defined COMPLEX_IS_PERIODIC
  using Periodic_tr = CGAL::Periodic_3_mesh_triangulation_3<CGAL::Labeled_mesh_domain_3<K> >::type;
  CGAL::Mesh_complex_3_in_triangulation_3<Periodic_tr> periodic;
  std::unordered_map<Periodic_tr::Vertex_handle, K::Point_3> images;
  CGAL::stretch_minimizing_volume_parameterization(periodic, VMP::make_vertex_point_map(images));
#elif defined TRIANGULATION_IS_REFINED
  Tr tr;
  VMP::make_parameterizable(tr);
#elif defined UNKNOWN_PARAMETER
  CGAL::stretch_minimizing_volume_parameterization(c3t3, uvw_map, params::verbose(true).vertex_point_map(uvw_map));
#elif defined UNKNOWN_PARAMETER_OF_BOUNDARY
  VMP::Ball_boundary_parameterizer_3().parameterize(c3t3, uvw_map, params::number_of_iterations(10));
#elif defined UNKNOWN_PARAMETER_OF_HEXAHEDRA
  CGAL::Polycube_meshing_3::Hexahedron_soup_3 hexahedra;
  CGAL::Polycube_meshing_3::make_hexahedral_mesh_3(c3t3, uvw_map, 0.1, hexahedra, params::verbose(true));
#else
  CGAL::stretch_minimizing_volume_parameterization(c3t3, uvw_map); // none
#endif
}
