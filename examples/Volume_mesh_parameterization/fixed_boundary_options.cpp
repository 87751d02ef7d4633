// Turns the interior of a ball against its boundary, with a solver, a visitor and fixed vertices of one's own.
#include "mesh_body.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Conjugate_gradient_solver_traits_3.h>

#include <CGAL/property_map.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <unordered_map>
#include <unordered_set>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

// Prints each step, and ends the computation when five steps in a row gained less than a thousandth.
struct Impatient_visitor
{
  double energy = 0;
  int small_steps = 0;

  bool after_step(const VMP::Parameterization_step& step)
  {
    std::cout << (step.phase == VMP::Phase::UNTANGLING ? "untangling, " : "minimization, ")
              << step.number_of_inverted_cells << " cells inverted, energy " << step.energy << "\n";
    small_steps = (step.energy > 0.999 * energy) ? small_steps + 1 : 0;
    energy = step.energy;
    return step.number_of_inverted_cells > 0 || small_steps < 5;
  }
};

int main()
{
  const auto ball = [](const Point_3& p) { return CGAL::squared_distance(p, Point_3(0, 0, 0)) - 1; };
  Domain domain = Domain::create_implicit_mesh_domain(ball, K::Sphere_3(CGAL::ORIGIN, 2.));
  const CGAL::Mesh_criteria_3<Tr> criteria(params::facet_angle = 25, params::facet_size = 0.25,
                                           params::facet_distance = 0.02, params::cell_radius_edge_ratio = 2,
                                           params::cell_size = 0.2);
  const C3t3 c3t3 = mesh_body(domain, criteria);

  // the vertices of a small ball in the middle are constrained; they turn about the z-axis, the boundary stays
  const auto point = c3t3.triangulation().geom_traits().construct_point_3_object();
  std::unordered_set<Vertex_handle> constrained;
  for(auto v = c3t3.triangulation().finite_vertices_begin(); v != c3t3.triangulation().finite_vertices_end(); ++v)
    if(ball(point(v->point())) < -0.9)
      constrained.insert(v);
  const auto target = [&](const Vertex_handle v)
  {
    const Point_3 p = point(v->point());
    const double angle = constrained.count(v) > 0 ? 1.5 : 0;
    const double c = std::cos(angle), s = std::sin(angle);
    return Point_3(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
  };

  VMP::Conjugate_gradient_solver_traits_3<CGAL::Parallel_if_available_tag, double> solver;
  Impatient_visitor visitor;
  std::unordered_map<Vertex_handle, Point_3> uvw;
  const VMP::Parameterization_result result
    = CGAL::stretch_minimizing_volume_parameterization<CGAL::Parallel_if_available_tag>(
        c3t3, VMP::make_vertex_point_map(uvw),
        params::boundary_map(boost::make_function_property_map<Vertex_handle>(target))
               .vertex_is_constrained_map(CGAL::Boolean_property_map<std::unordered_set<Vertex_handle> >(constrained))
               .boundary_mode(VMP::Boundary_mode::FIXED)
               .solver_traits(std::ref(solver))
               .visitor(std::ref(visitor))
               .number_of_iterations(200)
               .maximum_running_time(60));

  std::cout << result.message << "\n"
            << constrained.size() << " constrained vertices, "
            << result.number_of_inverted_cells_at_start << " cells inverted at the start, "
            << result.number_of_inverted_cells << " at the end\n"
            << "last linear system: " << solver.number_of_iterations() << " iterations" << std::endl;
  return result.has_valid_map ? EXIT_SUCCESS : EXIT_FAILURE;
}
