// Public functions that a visitor ends in the middle of each of their stages.
#include "catch.h"
#include "cube_complex.h"

#include <CGAL/Polycube_meshing_3/IO/write_hexahedron_soup.h>
#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Polycube_meshing_3/make_hexahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Ball_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/stretch_minimizing_volume_parameterization.h>

#include <CGAL/Timer.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace params = CGAL::parameters;
namespace PM = CGAL::Polycube_meshing_3;
namespace VMP = CGAL::Volume_mesh_parameterization;

namespace {

// Ends a computation when it is asked for the n-th time, and measures how long it goes on.
struct Impatient_visitor
{
  std::size_t n, number_of_questions = 0, number_of_later_steps = 0;
  CGAL::Timer since_the_end = {};

  bool after_step(const VMP::Parameterization_step&)
  {
    number_of_later_steps += since_the_end.is_running();
    return true;
  }

  bool goes_on()
  {
    if(++number_of_questions == n)
      since_the_end.start();
    return number_of_questions < n;
  }
};

// Keeps the steps that it is told of, and ends the computation with the last of some.
struct Recording_visitor
{
  std::size_t last = (std::numeric_limits<std::size_t>::max)();
  std::vector<VMP::Parameterization_step> steps = {};

  bool after_step(const VMP::Parameterization_step& step)
  {
    steps.push_back(step);
    return steps.size() < last;
  }

  // Returns whether all are numbered rounds of a phase.
  bool has_rounds_only(const VMP::Phase phase) const
  {
    for(std::size_t i = 0; i < steps.size(); ++i)
      if(steps[i].kind != VMP::Step_kind::ROUND || steps[i].phase != phase || steps[i].iteration != i + 1
         || steps[i].attempt.empty())
        return false;
    return !steps.empty();
  }
};

// Runs a function with a visitor to its end, and then ends it at questions spread over the whole run. It tells whether it
// was interrupted, and itself checks what it has written.
void check_ends(const std::function<bool(Impatient_visitor&)>& is_interrupted)
{
  Impatient_visitor patient = { (std::numeric_limits<std::size_t>::max)() };
  REQUIRE_FALSE(is_interrupted(patient));
  REQUIRE(patient.number_of_questions > 5);
  for(std::size_t k = 0; k < 12; ++k)
  {
    Impatient_visitor visitor = { 1 + k * (patient.number_of_questions - 1) / 12 };
    CAPTURE(visitor.n, patient.number_of_questions);
    CHECK(is_interrupted(visitor));
    CHECK(visitor.number_of_questions == visitor.n); // a visitor that has said no is not asked again
    CHECK(visitor.number_of_later_steps <= 1);
    CHECK(visitor.since_the_end.time() < 3);
  }
}

// Returns whether the map of a cube of 384 or more cells to a domain is interrupted, with further parameters of the map.
template <typename Parameterizer, typename Parameters>
bool is_map_interrupted(const Parameterizer& parameterizer, const Parameters& parameters)
{
  Cube_complex<> complex(cube_mesh(5));
  Cube_complex<>::Point_map target;
  REQUIRE(parameterizer.parameterize(complex.c3t3, VMP::make_vertex_point_map(target)) == VMP::OK);
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    complex.c3t3, complex.uvw_map(), parameters.boundary_map(VMP::make_vertex_point_map(target)));
  CAPTURE(result.status, result.message);
  CHECK((result.status == VMP::OK || result.status == VMP::ERROR_INTERRUPTED
         || result.status == VMP::ERROR_BOUNDARY_NOT_REACHED));
  CHECK(complex.uvw.empty() == !result.has_valid_map);
  if(result.has_valid_map)
    for(auto c = complex.c3t3.cells_in_complex_begin(); c != complex.c3t3.cells_in_complex_end(); ++c)
      REQUIRE(CGAL::orientation(complex.uvw.at(c->vertex(0)), complex.uvw.at(c->vertex(1)),
                                complex.uvw.at(c->vertex(2)), complex.uvw.at(c->vertex(3))) == CGAL::POSITIVE);
  return result.status == VMP::ERROR_INTERRUPTED;
}

} // namespace

TEST_CASE("A map with fixed boundary and refinement")
{
  check_ends([](Impatient_visitor& visitor)
  {
    return is_map_interrupted(VMP::Ball_boundary_parameterizer_3(), params::visitor(std::ref(visitor))
      .refinement_mode(VMP::Refinement_mode::HELPFUL));
  });
}

TEST_CASE("A map whose boundary slides, and with a bound of angles")
{
  check_ends([](Impatient_visitor& visitor)
  {
    return is_map_interrupted(VMP::Cube_boundary_parameterizer_3(1, 1, 3), params::visitor(std::ref(visitor))
      .refinement_mode(VMP::Refinement_mode::HELPFUL).do_slide_boundary(true)
      .maximum_angle_distortion(VMP::least_angle_distortion));
  });
}

TEST_CASE("A map with soft boundary")
{
  check_ends([](Impatient_visitor& visitor)
  {
    return is_map_interrupted(VMP::Ball_boundary_parameterizer_3(),
                              params::visitor(std::ref(visitor)).boundary_mode(VMP::Boundary_mode::SOFT));
  });
}

namespace {

// Counts its factorizations, and knows how many questions the visitor was asked before the first one.
struct Watched_solver : VMP::Conjugate_gradient_solver_traits_3<>
{
  const Impatient_visitor& visitor;
  std::size_t number_of_factorizations = 0, number_of_questions_before = 0;

  explicit Watched_solver(const Impatient_visitor& v) : visitor(v) {}

  VMP::Linear_solver_status factorize(const Matrix& A)
  {
    if(number_of_factorizations++ == 0)
      number_of_questions_before = visitor.number_of_questions;
    return VMP::Conjugate_gradient_solver_traits_3<>::factorize(A);
  }
};

} // namespace

TEST_CASE("The visitor is asked while a map is prepared, and what it has ended is not begun")
{
  Impatient_visitor patient = { (std::numeric_limits<std::size_t>::max)() };
  Watched_solver solver(patient);
  REQUIRE_FALSE(is_map_interrupted(VMP::Ball_boundary_parameterizer_3(),
                                   params::visitor(std::ref(patient)).solver_traits(std::ref(solver))));
  REQUIRE(solver.number_of_questions_before > 2);
  for(std::size_t n = 1; n <= solver.number_of_questions_before; ++n)
  {
    CAPTURE(n);
    Impatient_visitor visitor = { n };
    Watched_solver unused(visitor);
    CHECK(is_map_interrupted(VMP::Ball_boundary_parameterizer_3(),
                             params::visitor(std::ref(visitor)).solver_traits(std::ref(unused))));
    CHECK(unused.number_of_factorizations == 0);
  }
}

TEST_CASE("Maps of boundaries")
{
  const auto check = [](const auto& parameterizer)
  {
    check_ends([&](Impatient_visitor& visitor)
    {
      const Cube_complex<> complex(cube_mesh(8));
      Cube_complex<>::Point_map target;
      const VMP::Error_code status = parameterizer.parameterize(complex.c3t3, VMP::make_vertex_point_map(target),
                                                                params::visitor(std::ref(visitor)));
      CHECK((status == VMP::OK || (status == VMP::ERROR_INTERRUPTED && target.empty())));
      return status == VMP::ERROR_INTERRUPTED;
    });
  };
  check(VMP::Ball_boundary_parameterizer_3());
  check(VMP::Cube_boundary_parameterizer_3());
  check(PM::Polycube_boundary_parameterizer_3());
}

TEST_CASE("A visitor is told of rounds over the boundary and over hexahedra, and may end them")
{
  const auto check = [](const VMP::Phase phase, const auto& call)
  {
    Recording_visitor all;
    CHECK(call(all) == VMP::OK);
    CHECK(all.has_rounds_only(phase));
    Recording_visitor some = { 1 };
    CHECK(call(some) == VMP::ERROR_INTERRUPTED);
    CHECK(some.steps.size() == 1);
  };
  const auto check_boundary = [&](const auto& parameterizer)
  {
    check(VMP::Phase::BOUNDARY, [&](Recording_visitor& visitor)
    {
      const Cube_complex<> complex(cube_mesh(6));
      Cube_complex<>::Point_map target;
      return parameterizer.parameterize(complex.c3t3, VMP::make_vertex_point_map(target), params::visitor(std::ref(visitor)));
    });
  };
  check_boundary(VMP::Ball_boundary_parameterizer_3());
  check_boundary(VMP::Cube_boundary_parameterizer_3());
  check_boundary(PM::Polycube_boundary_parameterizer_3());
  const VMP::Tetrahedron_soup_3 soup = source_soup(cube_mesh(4));
  check(VMP::Phase::HEXAHEDRA, [&](Recording_visitor& visitor)
  {
    PM::Hexahedron_soup_3 mesh;
    const PM::Hexahedral_mesh_result result
      = PM::make_hexahedral_mesh_3(soup, soup.points, 1, mesh, params::visitor(std::ref(visitor)));
    return result.status;
  });

  // rounds are no steps of the map
  Cube_complex<> complex(cube_mesh(5));
  Recording_visitor visitor;
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    complex.c3t3, complex.uvw_map(), params::visitor(std::ref(visitor)));
  std::size_t number_of_rounds = 0;
  for(const VMP::Parameterization_step& step : visitor.steps)
    number_of_rounds += step.phase == VMP::Phase::BOUNDARY;
  CHECK(number_of_rounds > 0);
  CHECK(visitor.steps.size() == number_of_rounds + result.number_of_iterations);
}

TEST_CASE("A mesh that is read")
{
  std::ostringstream out;
  VMP::IO::write_MEDIT(out, source_soup(cube_mesh(20)));
  check_ends([&](Impatient_visitor& visitor)
  {
    std::istringstream in(out.str());
    VMP::Tetrahedron_soup_3 soup;
    const bool is_read = VMP::IO::read_MEDIT(in, soup, params::visitor(std::ref(visitor)));
    CHECK(soup.cells.empty() == !is_read);
    return !is_read;
  });
}

// A stage that is not begun has no direction, which is no fault of a number.
TEST_CASE("A map that is valid from the beginning is interrupted for no other reason")
{
  const VMP::Tetrahedron_soup_3 soup = source_soup(cube_mesh(3));
  check_ends([&](Impatient_visitor& visitor)
  {
    std::vector<std::array<double, 3> > images;
    const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
      soup, soup.points, images,
      params::initial_map(CGAL::make_property_map(soup.points)).visitor(std::ref(visitor)));
    CAPTURE(result.message);
    CHECK(result.message.find("not finite") == std::string::npos);
    return result.status == VMP::ERROR_INTERRUPTED;
  });
}
