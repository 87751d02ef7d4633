// Calls stretch_minimizing_volume_parameterization() and the readers of files with random input, and checks
// what they promise for any input. Meant to be run with sanitizers.
//
// Usage: fuzz_parameterization [NUMBER_OF_INPUTS [SEED]]
#include "complex_checks.h"
#include "fuzz_inputs.h"
#include "fuzz_loop.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/ARAP_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Any_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Barrier_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Bounded_angle_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/boundary_targets.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/LPM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/LSCM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Lp_stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/MIPS_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Power_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedron_soup_to_mesh_complex_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>

#include <boost/property_map/property_map.hpp>

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
#  include <CGAL/Volume_mesh_parameterization/CHOLMOD_solver_traits_3.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <iostream>
#include <limits>
#include <sstream>
#include <unordered_map>
#include <unordered_set>

namespace VMP = CGAL::Volume_mesh_parameterization;

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = K::Point_3;
using Tr = CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<K>;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;
using Vertex_handle = C3t3::Vertex_handle;
using Cell_handle = C3t3::Cell_handle;
using Vertex_set = std::unordered_set<Vertex_handle>;
using Point_map = std::unordered_map<Vertex_handle, Point_3>;
using CG = VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag, double>;

// Ends the computation after a number of steps.
struct Visitor
{
  std::size_t limit;
  std::size_t number_of_steps = 0;

  bool after_step(const VMP::Parameterization_step&) { return ++number_of_steps < limit; }
};

// Vertices without an entry have no target.
struct Target_map
{
  using key_type = Vertex_handle;
  using value_type = Point_3;
  using reference = Point_3;
  using category = boost::readable_property_map_tag;

  const Point_map* points;

  friend Point_3 get(const Target_map& map, const Vertex_handle v)
  {
    const auto found = map.points->find(v);
    const double none = std::numeric_limits<double>::quiet_NaN();
    return found == map.points->end() ? Point_3(none, none, none) : found->second;
  }
};

struct Is_constrained_map
{
  using key_type = Vertex_handle;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;

  const Vertex_set* vertices;

  friend bool get(const Is_constrained_map& map, const Vertex_handle v) { return map.vertices->count(v) > 0; }
};

const std::vector<VMP::Any_energy_3>& energies()
{
  static const std::vector<VMP::Any_energy_3> result = {
    VMP::Stretch_energy_3(), VMP::Dirichlet_energy_3(), VMP::ARAP_energy_3(), VMP::LSCM_energy_3(), VMP::LPM_energy_3(),
    VMP::MIPS_energy_3(), VMP::Symmetric_Dirichlet_energy_3(), VMP::Lp_stretch_energy_3(),
    VMP::Barrier_energy_3<VMP::ARAP_energy_3>(), VMP::Power_energy_3<VMP::MIPS_energy_3>(),
    VMP::Bounded_angle_energy_3<VMP::Stretch_energy_3>(3)
  };
  return result;
}

// All arguments of a call.
class Problem
{
public:
  Problem(const VMP::Tetrahedron_soup_3& soup, Random& random)
    : m_energy(random.one_in(2) ? energies().front() : energies()[random.below(energies().size())])
  {
    std::vector<Vertex_handle> vertices;
    std::vector<Cell_handle> cells;
    VMP::tetrahedron_soup_to_mesh_complex_3(soup, m_c3t3, vertices, cells);
    m_vertices.assign(vertices.begin(), vertices.end());
    m_vertices.erase(std::remove(m_vertices.begin(), m_vertices.end(), Vertex_handle()), m_vertices.end());
    if(m_vertices.empty())
      return;
    spoil_source(random);
    choose_targets(random);
    choose_parameters(random);
  }

  VMP::Error_code run(Random& random)
  {
    switch(random.below(3))
    {
      case 0: return run(CG());
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
      case 1: return run(VMP::CHOLMOD_solver_traits_3());
#endif
      default: return run(VMP::Conjugate_gradient_solver_traits_3<>());
    }
  }

private:
  // Complexes that no reader returns, but a user may pass.
  void spoil_source(Random& random)
  {
    if(!random.one_in(10))
      return;
    const Vertex_handle v = m_vertices[random.below(m_vertices.size())], w = m_vertices[random.below(m_vertices.size())];
    v->set_point(random.one_in(2) ? w->point() : Point_3(random.extreme_number(), v->point().y(), v->point().z()));
  }

  void choose_targets(Random& random)
  {
    std::vector<Eigen::Vector3d> points;
    for(const Vertex_handle v : m_vertices)
      points.push_back(VMP::internal::to_vector(v->point()));
    points = random_targets(points, random);
    const std::size_t missing = random.one_in(20) ? random.below(m_vertices.size()) : m_vertices.size();
    for(std::size_t i = 0; i < m_vertices.size(); ++i)
      if(i != missing)
        m_targets.emplace(m_vertices[i], Point_3(points[i][0], points[i][1], points[i][2]));
  }

  void choose_parameters(Random& random)
  {
    m_mode = random.pick({VMP::Boundary_mode::AUTO, VMP::Boundary_mode::FIXED, VMP::Boundary_mode::SOFT});
    m_refinement_mode = random.one_in(3) ? VMP::Refinement_mode::HELPFUL : VMP::Refinement_mode::NONE;
    m_do_slide = random.one_in(3);
    m_number_of_iterations = random.below(61);
    m_seconds = random.pick({0., 1e-3, 0.1, 100., 100., 100.});
    m_visitor.limit = random.one_in(4) ? 1 + random.below(20) : 1000;
    if(random.one_in(4))
      m_soft = VMP::single_weight_soft_boundary_parameters(random.pick({1e-100, 1., 1e8, 1e100}));
    m_soft.do_snap = !random.one_in(4);
    m_soft.use_full_hessian = random.one_in(4);
    for(std::size_t i = random.one_in(5) ? random.below(5) : 0; i > 0; --i)
      m_constrained.insert(m_vertices[random.below(m_vertices.size())]);
    for(std::size_t i = random.one_in(6) ? random.below(4) : 0; i > 0; --i)
    {
      VMP::Linear_constraint_3<Vertex_handle> constraint;
      for(std::size_t j = random.below(4); j > 0; --j)
        constraint.terms.push_back({m_vertices[random.below(m_vertices.size())], random.vector(1)});
      constraint.value = random.real(1);
      m_constraints.push_back(constraint);
    }
  }

  template <typename Solver>
  VMP::Error_code run(Solver solver)
  {
    const bool was_positive = has_positive_cells(m_c3t3);
    const std::size_t number_of_vertices = vertices_of_cells(m_c3t3).size();
    const std::clock_t begin = std::clock();
    const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
      m_c3t3, boost::make_assoc_property_map(m_images),
      CGAL::parameters::boundary_map(Target_map{&m_targets})
                       .energy(m_energy)
                       .solver_traits(std::ref(solver))
                       .boundary_mode(m_mode)
                       .refinement_mode(m_refinement_mode)
                       .do_slide_boundary(m_do_slide)
                       .soft_boundary_parameters(m_soft)
                       .positional_constraints(m_constraints)
                       .vertex_is_constrained_map(Is_constrained_map{&m_constrained})
                       .number_of_iterations(m_number_of_iterations)
                       .maximum_running_time(m_seconds)
                       .visitor(std::ref(m_visitor)));
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    expect(seconds < m_seconds + 5, "the time limit is respected");
    check_limits(result);
    check_complex(result, was_positive, number_of_vertices);
    check_map(result);
    return result.status;
  }

  bool may_refine() const { return m_refinement_mode != VMP::Refinement_mode::NONE; }

  void check_limits(const VMP::Parameterization_result& result) const
  {
    // Three stages and one more that slides; with refinement, a search for edges as well, and all of them again after each
    // round. A round adds at least one vertex, but for two that may be in vain.
    const std::size_t number_of_stages = may_refine() ? 5 * (3 + result.number_of_added_vertices) : 4;
    expect(result.number_of_iterations <= number_of_stages * m_number_of_iterations, "the number of iterations is respected");
    expect(m_visitor.number_of_steps == result.number_of_iterations, "the visitor is told of each step");
    expect(m_visitor.number_of_steps <= m_visitor.limit, "the visitor ends the computation");
    expect(!result.message.empty(), "there is a message");
  }

  void check_complex(const VMP::Parameterization_result& result,
                     const bool was_positive,
                     const std::size_t number_of_vertices) const
  {
    expect(has_positive_cells(m_c3t3) == was_positive, "refinement makes positive cells");
    expect(is_consistent(m_c3t3.triangulation()), "refinement keeps the triangulation valid");
    expect(result.number_of_cells == m_c3t3.number_of_cells_in_complex(), "the number of cells is right");
    expect(result.number_of_vertices == vertices_of_cells(m_c3t3).size(), "the number of vertices is right");
    expect(result.number_of_vertices == number_of_vertices + result.number_of_added_vertices,
           "the number of added vertices is right");
    expect(may_refine() || result.number_of_added_vertices == 0, "nothing is refined unless asked for");
    expect(m_do_slide || result.number_of_sliding_vertices == 0, "nothing slides unless asked for");
  }

  void check_map(const VMP::Parameterization_result& result) const
  {
    expect(result.status != VMP::OK || result.has_valid_map, "success means a valid map");
    expect(m_images.size() == (result.has_valid_map ? result.number_of_vertices : 0), "valid maps only are written");
    if(!result.has_valid_map)
      return;
    expect(has_positive_cells(m_c3t3, [&](const Vertex_handle v) { return m_images.at(v); }),
           "the map has finite coordinates and positive cells");
    expect(!std::isnan(result.energy), "the energy of a valid map is a number");
    expect(!std::isnan(result.boundary_residual), "the residual of a valid map is a number");
    expect(!std::isnan(result.distortion.angle_mean) && !std::isnan(result.distortion.volume_mean),
           "the distortions of a valid map are numbers");
    if(result.status != VMP::OK)
      return;
    Vertex_set prescribed = boundary_vertices(m_c3t3);
    prescribed.insert(m_constrained.begin(), m_constrained.end());
    std::size_t number_of_moved_vertices = 0;
    for(const Vertex_handle v : prescribed)
      if(const auto target = m_targets.find(v); // one without a target slides in the boundary of the source
         target == m_targets.end() || !has_same_bits(m_images.at(v), target->second))
        ++number_of_moved_vertices;
    expect(number_of_moved_vertices <= result.number_of_sliding_vertices, "success means an exact boundary");
    expect(result.boundary_residual == 0, "success means that nothing leaves its plane");
  }

  C3t3 m_c3t3;
  std::vector<Vertex_handle> m_vertices;
  VMP::Any_energy_3 m_energy;
  Point_map m_targets, m_images;
  Vertex_set m_constrained;
  std::vector<VMP::Linear_constraint_3<Vertex_handle> > m_constraints;
  VMP::Soft_boundary_parameters m_soft;
  VMP::Boundary_mode m_mode = VMP::Boundary_mode::AUTO;
  VMP::Refinement_mode m_refinement_mode = VMP::Refinement_mode::NONE;
  bool m_do_slide = false;
  std::size_t m_number_of_iterations = 0;
  double m_seconds = 0;
  Visitor m_visitor = {0};
};

// A mesh that went through a file, whose text may have been damaged.
VMP::Tetrahedron_soup_3 read_damaged_file(const VMP::Tetrahedron_soup_3& soup, Random& random)
{
  std::ostringstream mesh, targets;
  VMP::IO::write_MEDIT(mesh, soup);
  targets.precision(17);
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    targets << v << " " << soup.points[v][0] << " " << soup.points[v][1] << " " << soup.points[v][2] << "\n";

  std::string text = targets.str();
  mutate(text, random);
  std::vector<std::array<double, 3> > points;
  try
  {
    std::istringstream in(text);
    VMP::IO::read_boundary_targets(in, soup.points.size(), points);
    expect(points.size() == soup.points.size(), "there is a target or none for each vertex");
  }
  catch(const VMP::Input_error&)
  {
    expect(points.empty(), "targets are unchanged by a bad file");
  }

  text = mesh.str();
  mutate(text, random);
  std::istringstream in(text);
  VMP::Tetrahedron_soup_3 result;
  VMP::IO::read_MEDIT(in, result);
  return result;
}

// Runs a random input, and returns how the run ended.
std::string run_input(const std::uint64_t seed)
{
  Random random(seed);
  try
  {
    VMP::Tetrahedron_soup_3 soup = random_soup(random);
    if(random.one_in(4))
      soup = read_damaged_file(soup, random);
    return VMP::get_error_message(Problem(soup, random).run(random));
  }
  catch(const VMP::Input_error&)
  {
    return "The mesh is refused.";
  }
}

extern "C" const char* __asan_default_options() { return "abort_on_error=1"; }
// Has no counter of coverage: it is called before sanitizers allow to access memory.
extern "C" [[gnu::no_profile_instrument_function]] const char* __ubsan_default_options()
{ return "abort_on_error=1:print_stacktrace=1"; }

int main(int argc, char* argv[]) { return run_inputs(argc, argv, run_input); }
