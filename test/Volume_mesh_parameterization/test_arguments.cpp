// Arguments that no function must trust: arrays that do not fit together, numbers that are none, nothing at all.
#include "catch.h"
#include "complex_checks.h"
#include "cube_complex.h"

#include <CGAL/Polycube_meshing_3/IO/write_hexahedron_soup.h>
#include <CGAL/Polycube_meshing_3/Polycube_boundary_parameterizer_3.h>
#include <CGAL/Polycube_meshing_3/make_hexahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>
#include <CGAL/Volume_mesh_parameterization/make_parameterizable.h>
#include <CGAL/Volume_mesh_parameterization/measure_distortion.h>
#include <CGAL/Volume_mesh_parameterization/orient_tetrahedron_soup.h>
#include <CGAL/stretch_minimizing_volume_parameterization.h>

#include <CGAL/assertions_behaviour.h>
#include <CGAL/exceptions.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace PM = CGAL::Polycube_meshing_3;
namespace VMP = CGAL::Volume_mesh_parameterization;
namespace params = CGAL::parameters;

using Cells = std::vector<std::array<std::size_t, 4> >;
using Complex = Cube_complex<>;
using Points = std::vector<std::array<double, 3> >;
using PM::Hexahedron_soup_3;
using VMP::Tetrahedron_soup_3;

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Tetrahedron_soup_3 single_cell()
{ return { { {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1} }, { {0, 1, 2, 3} }, { 7 }, { {0, 1, 2} }, { 8 } }; }

Hexahedron_soup_3 single_hexahedron()
{
  Hexahedron_soup_3 mesh;
  mesh.points = { {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1} };
  mesh.images = mesh.points;
  mesh.cells = { {0, 1, 2, 3, 4, 5, 6, 7} };
  mesh.cell_blocks = { 1 };
  mesh.cell_indices = { {0, 0, 0} };
  mesh.cell_references = { 0 };
  mesh.facets = { {0, 3, 2, 1} };
  mesh.facet_cells = { 0 };
  mesh.polycube_faces = { 1 };
  mesh.facet_references = { 0 };
  return mesh;
}

// All writers of tetrahedra refuse the soup, and write nothing.
void check_refused(const Tetrahedron_soup_3& soup)
{
  std::ostringstream os;
  CHECK_THROWS_AS(VMP::IO::write_MEDIT(os, soup), VMP::Input_error);
  CHECK_THROWS_AS(VMP::IO::write_VTU(os, soup, soup.points), VMP::Input_error);
  CHECK(os.str().empty());
}

void check_refused(const Hexahedron_soup_3& mesh)
{
  std::ostringstream os;
  CHECK_THROWS_AS(PM::IO::write_MEDIT(os, mesh), VMP::Input_error);
  CHECK_THROWS_AS(PM::IO::write_VTU(os, mesh), VMP::Input_error);
  CHECK_THROWS_AS(PM::IO::write_INP(os, mesh), VMP::Input_error);
  CHECK(os.str().empty());
}

// Energy that a user passes who asks for any valid map.
struct Constant_energy
{
  double constant;

  template <typename T>
  T value(const Eigen::Matrix<T, 3, 1>&) const { return T(constant); }

  template <typename T>
  Eigen::Matrix<T, 3, 1> gradient(const Eigen::Matrix<T, 3, 1>&) const { return Eigen::Matrix<T, 3, 1>::Constant(T(0)); }

  template <typename T>
  Eigen::Matrix<T, 3, 3> hessian(const Eigen::Matrix<T, 3, 1>&) const { return Eigen::Matrix<T, 3, 3>::Constant(T(0)); }
};

template <typename NamedParameters>
VMP::Parameterization_result parameterize_complex(Complex& complex, const NamedParameters& np)
{
  return CGAL::stretch_minimizing_volume_parameterization(std::as_const(complex.c3t3), complex.uvw_map(),
                                                          np.boundary_map(complex.boundary_map()));
}

} // namespace

TEST_CASE("Arrays that do not fit together are not written")
{
  const auto spoilt = [](const auto& spoil)
  {
    Tetrahedron_soup_3 soup = single_cell();
    spoil(soup);
    return soup;
  };
  check_refused(spoilt([](auto& soup) { soup.cell_references.clear(); }));
  check_refused(spoilt([](auto& soup) { soup.facet_references.clear(); }));
  check_refused(spoilt([](auto& soup) { soup.cells[0][3] = 4; }));
  check_refused(spoilt([](auto& soup) { soup.facets[0][2] = 1000000; }));

  const Tetrahedron_soup_3 soup = single_cell();
  std::ostringstream os;
  CHECK_THROWS_AS(VMP::IO::write_VTU(os, soup, Points()), CGAL::Precondition_exception); // as where there is no map
  CHECK(os.str().empty());
  VMP::IO::write_VTU(os, soup, soup.points);
  CHECK(os);
}

TEST_CASE("Arrays of hexahedra that do not fit together are not written")
{
  const auto spoilt = [](const auto& spoil)
  {
    Hexahedron_soup_3 mesh = single_hexahedron();
    spoil(mesh);
    return mesh;
  };
  check_refused(spoilt([](auto& mesh) { mesh.images.clear(); }));
  check_refused(spoilt([](auto& mesh) { mesh.cell_blocks.clear(); }));
  check_refused(spoilt([](auto& mesh) { mesh.cell_indices.clear(); }));
  check_refused(spoilt([](auto& mesh) { mesh.cell_references.clear(); }));
  check_refused(spoilt([](auto& mesh) { mesh.facet_cells.clear(); }));
  check_refused(spoilt([](auto& mesh) { mesh.polycube_faces.clear(); }));
  check_refused(spoilt([](auto& mesh) { mesh.facet_references.clear(); }));
  check_refused(spoilt([](auto& mesh) { mesh.cells[0][7] = 8; }));
  check_refused(spoilt([](auto& mesh) { mesh.facets[0][3] = 8; }));
  check_refused(spoilt([](auto& mesh) { mesh.facet_cells[0] = 1; }));

  std::ostringstream os;
  PM::IO::write_MEDIT(os, single_hexahedron());
  PM::IO::write_VTU(os, single_hexahedron());
  PM::IO::write_INP(os, single_hexahedron());
  CHECK(os);
}

TEST_CASE("Distortions of cells are refused where points or images are missing")
{
  const Tetrahedron_soup_3 soup = single_cell();
  CHECK(VMP::cell_distortions(soup.points, soup.cells, soup.points).front().angle == Approx(2));
  CHECK_THROWS_AS(VMP::cell_distortions(soup.points, soup.cells, Points()), CGAL::Precondition_exception);
  CHECK_THROWS_AS(VMP::cell_distortions(soup.points, Cells{ {0, 1, 2, 4} }, soup.points), VMP::Input_error);
}

TEST_CASE("Nothing at all is answered by all functions of arrays and complexes")
{
  Points none, images;
  Cells no_cells;
  Tetrahedron_soup_3 soup;
  CHECK(CGAL::stretch_minimizing_volume_parameterization(none, no_cells, none, images).status == VMP::ERROR_EMPTY_COMPLEX);
  CHECK(CGAL::stretch_minimizing_volume_parameterization<CGAL::Parallel_if_available_tag>(soup, none, images).status
        == VMP::ERROR_EMPTY_COMPLEX);
  CHECK(CGAL::stretch_minimizing_volume_parameterization(none, no_cells, none, images,
                                                         params::refinement_mode(VMP::Refinement_mode::HELPFUL)).status
        == VMP::ERROR_EMPTY_COMPLEX);
  CHECK(VMP::make_parameterizable(none, no_cells) == 0);
  CHECK(VMP::cell_distortions(none, no_cells, none).empty());
  VMP::measure_distortion(none, no_cells, none);
  CHECK(VMP::boundary_vertices(none, no_cells).empty());
  CHECK(VMP::non_manifold_boundary_vertices(none, no_cells).empty());
  CHECK(PM::Polycube_boundary_parameterizer_3().parameterize(none, no_cells, images) == VMP::ERROR_EMPTY_COMPLEX);
  CHECK_FALSE(VMP::Volume_map_3(none, no_cells, none).image({ 0, 0, 0 }));
  CHECK(VMP::Volume_map_3(none, no_cells, none).images(std::vector<Complex::Point_3>()).empty());
  Hexahedron_soup_3 hexahedra;
  CHECK(PM::make_hexahedral_mesh_3(none, no_cells, none, 1, hexahedra).status == VMP::ERROR_EMPTY_COMPLEX);
  VMP::orient_tetrahedron_soup(soup);
  std::ostringstream os;
  VMP::IO::write_MEDIT(os, soup);
  VMP::IO::write_VTU(os, soup, none);
  PM::IO::write_MEDIT(os, hexahedra);
  PM::IO::write_VTU(os, hexahedra);
  PM::IO::write_INP(os, hexahedra);
  CHECK(os);

  Complex::C3t3 c3t3;
  Complex::Point_map uvw;
  const auto uvw_map = VMP::make_vertex_point_map(uvw);
  CHECK(CGAL::stretch_minimizing_volume_parameterization(std::as_const(c3t3), uvw_map, params::boundary_map(uvw_map)).status
        == VMP::ERROR_EMPTY_COMPLEX);
  CHECK(CGAL::stretch_minimizing_volume_parameterization(c3t3, uvw_map).status == VMP::ERROR_EMPTY_COMPLEX);
  CHECK(VMP::make_parameterizable(c3t3) == 0);
  CHECK(PM::make_hexahedral_mesh_3(c3t3, uvw_map, 1, hexahedra).status == VMP::ERROR_EMPTY_COMPLEX);
}

TEST_CASE("Any valid map is found for an energy that is constant")
{
  const double constant = GENERATE(0., 5.);
  const VMP::Boundary_mode mode = GENERATE(VMP::Boundary_mode::FIXED, VMP::Boundary_mode::SOFT);
  CAPTURE(constant, static_cast<int>(mode));
  Complex complex(twisted_cube(4, 0.1));
  const VMP::Parameterization_result result
    = parameterize_complex(complex, params::energy(Constant_energy{ constant }).boundary_mode(mode));
  INFO(result.message);
  CHECK(result.status == VMP::OK);
  CHECK(result.boundary_residual == 0);
  CHECK(result.energy == Approx(constant));
  CHECK(has_positive_cells(complex.c3t3, [&](const auto v) { return complex.uvw.at(v); }));
}

TEST_CASE("Numbers that limit nothing are refused by name")
{
  Complex complex(twisted_cube(2));
  const auto check = [&](const auto& np, const std::string& sentence)
  {
    CHECK_THROWS_AS(parameterize_complex(complex, np), CGAL::Precondition_exception);
    CHECK_THROWS_WITH(parameterize_complex(complex, np), Catch::Matchers::Contains(sentence));
    CHECK(complex.uvw.empty());
  };
  check(params::number_of_iterations(infinity), "number_of_iterations");
  check(params::number_of_iterations(nan_value), "number_of_iterations");
  check(params::maximum_running_time(nan_value), "maximum_running_time");
  check(params::maximum_running_time(-1), "maximum_running_time must not be negative.");
  const auto soft = [](const double weight, const double factor)
  {
    VMP::Soft_boundary_parameters parameters;
    parameters.weight = weight;
    parameters.weight_factor = factor;
    return params::boundary_mode(VMP::Boundary_mode::SOFT).soft_boundary_parameters(parameters);
  };
  for(const double weight : { 0., -1., nan_value, infinity })
    check(soft(weight, 25), "weight of soft_boundary_parameters");
  for(const double factor : { 1., 0., nan_value, infinity })
    check(soft(100, factor), "weight_factor of soft");
  for(double VMP::Soft_boundary_parameters::*const tolerance
      : { &VMP::Soft_boundary_parameters::residual_tolerance, &VMP::Soft_boundary_parameters::energy_tolerance,
          &VMP::Soft_boundary_parameters::relative_energy_tolerance, &VMP::Soft_boundary_parameters::step_tolerance,
          &VMP::Soft_boundary_parameters::gradient_tolerance })
    for(const double value : { -1., nan_value })
    {
      VMP::Soft_boundary_parameters parameters;
      parameters.*tolerance = value;
      check(params::soft_boundary_parameters(parameters), "tolerances of soft_boundary_parameters");
    }
  CHECK_THROWS_AS(VMP::Conjugate_gradient_solver_traits_3<>(-1), CGAL::Precondition_exception);
  CHECK(parameterize_complex(complex, soft(100, 25)).has_valid_map);
  CHECK(parameterize_complex(complex, params::number_of_iterations(1e300)).status == VMP::OK);

  Points images;
  const Tetrahedron_soup_3 soup = single_cell();
  CHECK_THROWS_AS(PM::Polycube_boundary_parameterizer_3().parameterize(soup.points, soup.cells, images,
                                                                         params::maximum_running_time(nan_value)),
                  CGAL::Precondition_exception);
}

TEST_CASE("A broken precondition names the place where it is asked")
{
  Complex complex(twisted_cube(2));
  try
  {
    parameterize_complex(complex, params::energy_tolerance(-1.));
    FAIL("no exception");
  }
  catch(const CGAL::Precondition_exception& error)
  {
    CHECK(error.filename().find("named_parameters_3.h") != std::string::npos);
    CHECK(error.line_number() > 0);
    CHECK(error.message() == "energy_tolerance must not be negative.");
  }
}

TEST_CASE("A broken precondition is reported to the handler of CGAL")
{
  static std::string reported;
  const CGAL::Failure_function before = CGAL::set_error_handler(
    [](const char* kind, const char*, const char*, int, const char* message) { reported = std::string(kind) + ": " + message; });
  CHECK_THROWS_AS(VMP::cell_distortions(Points(), Cells(), Points(1)), CGAL::Precondition_exception);
  CGAL::set_error_handler(before);
  CHECK(reported == "precondition: images must have an element for each point.");
}
