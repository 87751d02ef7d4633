// One mistake of a caller, chosen by a macro, which the compiler answers with a sentence of this package.
#include <CGAL/stretch_minimizing_volume_parameterization.h>

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

void call(const C3t3& c3t3, std::unordered_map<Vertex_handle, K::Point_3>& uvw)
{
#ifdef TARGETS_ARE_A_FUNCTION
  const auto target = [](const Vertex_handle v) { return v->point(); };
  CGAL::stretch_minimizing_volume_parameterization(c3t3, VMP::make_vertex_point_map(uvw), params::boundary_map(target));
#elif defined TARGETS_ARE_A_CONTAINER
  CGAL::stretch_minimizing_volume_parameterization(c3t3, VMP::make_vertex_point_map(uvw), params::boundary_map(uvw));
#elif defined IMAGES_ARE_A_CONTAINER
  CGAL::stretch_minimizing_volume_parameterization(c3t3, uvw);
#elif defined IMAGES_ARE_NUMBERS
  std::unordered_map<Vertex_handle, double> numbers;
  CGAL::stretch_minimizing_volume_parameterization(c3t3, boost::make_assoc_property_map(numbers));
#elif defined CONSTANT_COMPLEX_IS_REFINED
  CGAL::stretch_minimizing_volume_parameterization(c3t3, VMP::make_vertex_point_map(uvw), params::do_refine(true));
#elif defined ARRAYS_ARE_REFINED
  std::vector<std::array<double, 3> > points;
  CGAL::stretch_minimizing_volume_parameterization(points, std::vector<std::array<std::size_t, 4> >(), points, points,
                                                   params::do_refine(true));
#else
  CGAL::stretch_minimizing_volume_parameterization(c3t3, VMP::make_vertex_point_map(uvw)); // none
#endif
}
