// Meshes that several processes share. All processes run all tests; mpirun -n 1, 2, 3 mpi_tests.
#define CATCH_CONFIG_RUNNER
#include "catch.h"
#include "cube_mesh.h"

#include <CGAL/Volume_mesh_parameterization/Distributed/Distributed_tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Distributed/IO.h>
#include <CGAL/Volume_mesh_parameterization/Distributed/distributed_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/IO/boundary_targets.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Distributed/Distributed_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Distributed/MPI_communicator_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/patches_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/untangle_patches_3.h>
#include <CGAL/Volume_mesh_parameterization/make_parameterizable.h>
#include <CGAL/stretch_minimizing_volume_parameterization.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <petscsys.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <new>
#include <sstream>
#include <string>
#include <vector>

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

using Point = std::array<double, 3>;
using Points = std::vector<Point>;
using Result = VMP::Parameterization_result;
using Soup = VMP::Tetrahedron_soup_3;
using Distributed_soup = VMP::Distributed_tetrahedron_soup_3;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

const VMP::internal::MPI_communicator_3& world()
{
  static const auto* const communicator = new VMP::internal::MPI_communicator_3(MPI_COMM_WORLD); // until the very end
  return *communicator;
}
int rank() { return world().rank(); }
int size() { return world().size(); }
int culprit() { return size() / 2; } // which alone does something wrong

// Put together from the slices of all processes.
template <typename T>
std::vector<T> whole(const std::vector<T>& slice)
{
  return world().exchanged(std::vector<std::vector<T> >(size(), slice));
}

bool is_same_everywhere(const std::string& text)
{
  const double hash = static_cast<double>(std::hash<std::string>()(text) % (1 << 20));
  return world().minimum(hash) == world().maximum(hash);
}

// A mesh that all processes know, with the targets of all its points.
struct Problem
{
  Soup soup;
  Points targets;

  std::size_t begin(const int r) const { return soup.points.size() * r / size(); }

  // The slice of a process; its cells have nothing to do with its points.
  Distributed_soup slice() const
  {
    Distributed_soup result;
    result.points.assign(soup.points.begin() + begin(rank()), soup.points.begin() + begin(rank() + 1));
    for(std::size_t c = rank(); c < soup.cells.size(); c += size())
      result.cells.push_back(soup.cells[soup.cells.size() - 1 - c]);
    result.cell_references.assign(result.cells.size(), 0);
    return result;
  }

  Points slice_of_targets() const
  {
    return Points(targets.begin() + begin(rank()), targets.begin() + begin(rank() + 1));
  }
};

// Only the targets of the boundary may be read.
Problem problem_of(const VMP::internal::Numbered_mesh_3& mesh)
{
  Problem problem = { source_soup(mesh), {} };
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    problem.targets.push_back({ mesh.target(0, v), mesh.target(1, v), mesh.target(2, v) });
  for(int v = 0; v < mesh.number_of_free_vertices; ++v)
    problem.targets[v].fill(none);
  return problem;
}

bool is_valid(const Soup& soup, const Points& images)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto p = [&](const std::size_t v) { return Kernel::Point_3(images[v][0], images[v][1], images[v][2]); };
  return std::all_of(soup.cells.begin(), soup.cells.end(), [&](const std::array<std::size_t, 4>& c)
  {
    return CGAL::orientation(p(c[0]), p(c[1]), p(c[2]), p(c[3])) == CGAL::POSITIVE;
  });
}

// Compares with the map of one process, which does without PETSc: the number of iterations, too, of which at least a part
// is needed. Returns how both were untangled.
template <typename NamedParameters>
std::string check_map(const Problem& problem, const NamedParameters& np, const double least_part_of_iterations = 0.4)
{
  Points expected, slice;
  const Result serial = CGAL::stretch_minimizing_volume_parameterization(problem.soup.points, problem.soup.cells,
                                                                         problem.targets, expected, np);
  const Result result
    = CGAL::stretch_minimizing_volume_parameterization(problem.slice(), problem.slice_of_targets(), slice, np);
  REQUIRE(serial.status == VMP::OK);
  REQUIRE(serial.number_of_inverted_cells_at_start > 0);
  REQUIRE(result.status == VMP::OK);
  CHECK(result.energy == Approx(serial.energy).epsilon(1e-9));
  CHECK(result.distortion.angle_mean == Approx(serial.distortion.angle_mean).epsilon(1e-6));
  CHECK(result.distortion.volume_max == Approx(serial.distortion.volume_max).epsilon(1e-4));
  CHECK(result.untangling_method == serial.untangling_method);
  CHECK(result.number_of_cells == serial.number_of_cells);
  CHECK(result.number_of_vertices == serial.number_of_vertices);
  CHECK(result.number_of_boundary_vertices == serial.number_of_boundary_vertices);
  CHECK(result.number_of_inverted_cells_at_start == serial.number_of_inverted_cells_at_start);
  CHECK(result.boundary_residual == 0);
  const double iterations = static_cast<double>(serial.number_of_linear_solver_iterations);
  CHECK(result.number_of_linear_solver_iterations <= 1.1 * iterations);
  CHECK(result.number_of_linear_solver_iterations >= least_part_of_iterations * iterations);

  const Points images = whole(slice);
  CHECK(is_valid(problem.soup, images));
  double largest = 0;
  bool meets_boundary = true;
  for(std::size_t v = 0; v < images.size(); ++v)
  {
    largest = (std::max)(largest, (Eigen::Map<const Eigen::Vector3d>(images[v].data())
                                   - Eigen::Map<const Eigen::Vector3d>(expected[v].data())).norm());
    if(!std::isnan(problem.targets[v][0]))
      meets_boundary = meets_boundary && images[v] == problem.targets[v];
  }
  CHECK(largest < 1e-6 * std::cbrt(problem.soup.cells.size())); // the diagonal is longer
  CHECK(meets_boundary);
  return result.untangling_method;
}

// Returns how the call ends if only the culprit has changed its part.
template <typename NamedParameters>
std::string end_of(const Distributed_soup& soup, const Points& targets, const NamedParameters& np)
{
  Points images = { {1, 2, 3} };
  std::string end;
  try
  {
    const Result result = CGAL::stretch_minimizing_volume_parameterization(soup, targets, images, np);
    end = std::to_string(result.status) + ": " + result.message;
    if(!result.has_valid_map)
      CHECK(images == Points{ {1, 2, 3} });
  }
  catch(const std::bad_alloc&) { end = "memory"; }
  catch(const VMP::Input_error& error) { end = std::string("input: ") + error.what(); }
  catch(const std::runtime_error& error) { end = std::string("other: ") + error.what(); }
  CHECK(is_same_everywhere(end));
  UNSCOPED_INFO(end);
  return end;
}

template <typename AfterStep>
struct Visitor
{
  bool after_step(const VMP::Parameterization_step& step) const { return rank() != culprit() || f(step); }
  AfterStep f;
};
template <typename AfterStep> Visitor(AfterStep) -> Visitor<AfterStep>;

std::string file(const std::string& name, const std::string& text)
{
  const std::string path = "mpi_" + std::to_string(size()) + "_" + name;
  world().synchronize();
  if(rank() == 0)
    std::ofstream(path, std::ios::binary) << text;
  world().synchronize();
  return path;
}

std::string text_of(const std::string& path)
{
  std::ostringstream os;
  os << std::ifstream(path, std::ios::binary).rdbuf();
  return os.str();
}

template <typename Read>
std::string error_of(const Read& read)
{
  std::string error;
  try { read(); } catch(const VMP::Input_error& e) { error = e.what(); }
  CHECK(is_same_everywhere(error));
  return error;
}

} // namespace

TEST_CASE("the map of several processes is that of one")
{
  const Problem problem = problem_of(ring(6));
  check_map(problem, params::number_of_iterations(200));
  CHECK(check_map(problem_of(ring(4)), params::number_of_iterations(200)) == "patches");
  check_map(problem, params::energy(VMP::Symmetric_Dirichlet_energy_3()).use_volume_weights(true));
}

// The vertices on a line through the cube are so near to others that the cells between them are flat.
TEST_CASE("what patches see of a mesh, and change, is the same with one process and with several")
{
  namespace internal = VMP::internal;
  constexpr double distance = 0.995;
  const auto image_of = [&](Eigen::Matrix3Xd points)
  {
    for(Eigen::Index v = 0; v < points.cols(); ++v)
      if(points(1, v) == 3 && points(2, v) == 3 && points(0, v) > 0 && points(0, v) < 6)
        points(1, v) += distance;
    return points;
  };
  const auto is_flat = [&](const Eigen::Matrix3Xd& positions, const std::array<int, 4>& cell)
  { return internal::edge_matrix(positions, cell).determinant() < 0.01; };
  const internal::Numbered_mesh_3 mesh = cube_mesh(6);
  const Problem problem = problem_of(mesh);
  const internal::Distributed_mesh_3 distributed(world(), problem.slice(), problem.slice_of_targets(),
                                                 [](std::size_t) { return false; }, false);
  const internal::Numbered_mesh_3& part = distributed.mesh();
  Eigen::Matrix3Xd serial = image_of(mesh.source), image = image_of(part.source);
  REQUIRE(internal::inverted_cells(mesh, serial).number == 0);
  const double holds_flat = std::any_of(part.cells.begin(), part.cells.end() - part.number_of_copied_cells,
                                        [&](const auto& cell) { return is_flat(image, cell); });
  REQUIRE(world().sum(holds_flat) == (std::min)(size(), 2));

  const std::vector<internal::Patch_3> patches = internal::patches_3(mesh, serial, is_flat, 2);
  REQUIRE(patches.size() == 1);
  const internal::Patch_mesh_3 patch(mesh, serial, patches.front());
  const internal::Neighborhood_3 neighborhood(part, image, is_flat, 2);
  const internal::Numbered_mesh_3& gathered = neighborhood.mesh();
  const int n = gathered.number_of_free_vertices;
  REQUIRE(n == patch.mesh.number_of_free_vertices);
  CHECK(gathered.number_of_vertices() == patch.mesh.number_of_vertices());
  CHECK(gathered.cells.size() == patch.mesh.cells.size());
  CHECK(gathered.source.leftCols(n) == patch.mesh.source.leftCols(n));
  CHECK(neighborhood.positions().leftCols(n) == patch.positions.leftCols(n));
  CHECK(internal::volume(gathered, gathered.source) == Approx(internal::volume(patch.mesh, patch.mesh.source)));
  CHECK(neighborhood.agreed_positions([]() -> internal::Matrix3Xd { return Eigen::Matrix3Xd::Constant(3, 2, rank()); }).isZero(0));
  const auto fail = []() -> internal::Matrix3Xd { throw std::bad_alloc(); };
  CHECK_THROWS_AS(world().together([&]() { return neighborhood.agreed_positions(fail); }), std::bad_alloc);

  VMP::Conjugate_gradient_solver_traits_3<CGAL::Sequential_tag> traits;
  internal::Linear_solver_of<decltype(traits)> solver(traits);
  const Eigen::Matrix3Xd before = serial;
  serial = internal::relaxed_flat_cells_3(mesh, solver, serial, internal::Budget());
  image = internal::relaxed_flat_cells_3(part, solver, image, internal::Budget());
  CHECK((serial - before).norm() > 0.1);
  for(int v = 0; v < part.number_of_vertices(); ++v)
    CHECK((image.col(v) - serial.col(static_cast<Eigen::Index>(part.vertex_numbers[v]))).norm() < 1e-6);
}

TEST_CASE("fewer cells than processes, negative cells, and points without a cell")
{
  Problem problem;
  problem.soup.points = { {9, 9, 9}, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1} };
  problem.soup.cells = { {1, 2, 3, 4} };
  problem.targets = { {none, none, none}, {0, 0, 0}, {0, 2, 0}, {2, 0, 0}, {0, 0, 2} };
  Points slice;
  const Result result
    = CGAL::stretch_minimizing_volume_parameterization(problem.slice(), problem.slice_of_targets(), slice);
  CHECK(result.status == VMP::OK);
  const Points images = whole(slice);
  CHECK(std::isnan(images[0][0]));
  CHECK(Points(images.begin() + 1, images.end()) == Points(problem.targets.begin() + 1, problem.targets.end()));
}

TEST_CASE("PETSc's options choose the solver")
{
  const Problem problem = problem_of(ring(5));
  PetscOptionsSetValue(nullptr, "-pc_type", "gamg");
  check_map(problem, params::number_of_iterations(200), 0.2); // multigrid needs about a fourth of them
  PetscOptionsClearValue(nullptr, "-pc_type");
}

TEST_CASE("a solver that ends at its limit of iterations is named")
{
  const Problem problem = problem_of(ring(4));
  const auto end_with_limit = [&](const char* limit)
  {
    PetscOptionsSetValue(nullptr, "-ksp_max_it", limit);
    return end_of(problem.slice(), problem.slice_of_targets(), params::number_of_iterations(200));
  };
  const std::string end = end_with_limit("3");
  CHECK(end.find("linear solver reached its limit of iterations") != std::string::npos);
  CHECK(end.find("PETSc's option -ksp_max_it sets it.") != std::string::npos);
  CHECK(end_with_limit("1000").find("limit of iterations") == std::string::npos);
  PetscOptionsClearValue(nullptr, "-ksp_max_it");
}

TEST_CASE("an error of one process is that of all")
{
  const Problem problem = problem_of(ring(4));
  Distributed_soup soup = problem.slice();
  Points targets = problem.slice_of_targets();
  const bool is_culprit = rank() == culprit();
  const auto np = params::number_of_iterations(200);
  const auto with = [](const auto& after_step) { return params::visitor(Visitor{ after_step }); };

  if(is_culprit)
    soup.cells[0][2] = 1000;
  CHECK(end_of(soup, targets, np).find(" has a vertex 1000 that does not exist") != std::string::npos);
  soup = problem.slice();
  if(is_culprit)
    std::swap(soup.cells[0][1], soup.cells[0][2]);
  CHECK(end_of(soup, targets, np).find("on the same side") != std::string::npos);
  soup = problem.slice();
  if(is_culprit)
    soup.points[0][1] = none;
  CHECK(end_of(soup, targets, np).find(std::to_string(VMP::ERROR_NON_FINITE_COORDINATE) + ":") == 0);
  soup = problem.slice();
  if(rank() == size() - 1) // the vertices of the boundary come last
    targets.back().fill(none);
  CHECK(end_of(soup, targets, np).find(std::to_string(VMP::ERROR_MISSING_BOUNDARY_TARGET) + ": The boundary vertex") == 0);
  targets = problem.slice_of_targets();
  if(is_culprit)
    targets.pop_back();
  CHECK(end_of(soup, targets, np).find("targets must have an element for each point") != std::string::npos);
  targets = problem.slice_of_targets();

  const std::string interrupted = std::to_string(VMP::ERROR_INTERRUPTED) + ":";
  CHECK(end_of(soup, targets, with([](const auto& step) { return step.iteration < 2; })).find(interrupted) == 0);
  CHECK(end_of(soup, targets, params::maximum_running_time(is_culprit ? 0. : 1e9)).find(interrupted) == 0);
  CHECK(end_of(soup, targets, with([](const auto&) -> bool { throw std::bad_alloc(); })) == "memory");
  CHECK(end_of(soup, targets, with([](const auto&) -> bool { throw std::runtime_error("out of luck"); }))
        == "other: out of luck");
  CHECK(end_of(soup, targets, np).find("0:") == 0); // and none of this has left anything behind
}

TEST_CASE("targets that allow no map are told apart")
{
  Problem problem = problem_of(ring(4));
  for(Point& target : problem.targets)
    target[0] = -target[0];
  CHECK(end_of(problem.slice(), problem.slice_of_targets(), params::number_of_iterations(5)).find("inside out")
        != std::string::npos);
  problem = problem_of(ring(4));
  CHECK(end_of(problem.slice(), problem.slice_of_targets(), params::number_of_iterations(0))
          .find(std::to_string(VMP::ERROR_NOT_FLIP_FREE) + ":") == 0);
}

// An octahedron of four cells around an edge, which is outside of the target, as an equatorial vertex is beyond it. Distributed
// meshes cannot be refined in the call, and who is told so can do it before.
TEST_CASE("a mesh that was made parameterizable before can be mapped")
{
  Problem problem;
  problem.soup.points = { {0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0} };
  for(std::size_t i = 0; i < 4; ++i)
    problem.soup.cells.push_back({ 0, 1, 2 + i, 2 + (i + 1) % 4 });
  problem.soup.cell_references.assign(4, 0);
  problem.targets = problem.soup.points;
  problem.targets[2] = { -0.2, 0, 0 };
  const auto np = params::number_of_iterations(200);
  CHECK(end_of(problem.slice(), problem.slice_of_targets(), np)
          .find(std::to_string(VMP::ERROR_PRESCRIBED_CELL_INVERTED) + ":") == 0);

  CHECK(VMP::make_parameterizable(problem.soup, params::boundary_map(CGAL::make_property_map(problem.targets))) == 1);
  problem.targets.push_back({ none, none, none });
  Points slice;
  const Result result
    = CGAL::stretch_minimizing_volume_parameterization(problem.slice(), problem.slice_of_targets(), slice, np);
  CHECK(result.status == VMP::OK);
  CHECK(result.number_of_cells == 8);
  CHECK(is_valid(problem.soup, whole(slice)));
}

TEST_CASE("each process reads a part of the files")
{
  const std::string mesh = DATA "/cube.mesh", targets = DATA "/cube_to_ball.txt";
  Problem expected;
  VMP::IO::read_MEDIT(mesh, expected.soup);
  VMP::IO::read_boundary_targets(targets, expected.soup, expected.targets);
  Distributed_soup soup;
  Points slice;
  VMP::IO::read_MEDIT(mesh, soup);
  VMP::IO::read_boundary_targets(targets, soup, slice);
  CHECK(whole(soup.points) == expected.soup.points);
  CHECK(soup.points.size() <= expected.soup.points.size() / size() + 1);
  CHECK(soup.cells.size() <= expected.soup.cells.size() / size() + 1);
  const Points read = whole(slice);
  for(std::size_t v = 0; v < read.size(); ++v)
    CHECK((read[v] == expected.targets[v] || (std::isnan(read[v][0]) && std::isnan(expected.targets[v][0]))));
  CHECK(whole(soup.cells) == expected.soup.cells);
  CHECK(whole(soup.cell_references) == expected.soup.cell_references);

  VMP::IO::read_boundary_targets(mesh, soup, slice); // a copy with other coordinates
  CHECK(slice == soup.points);

  Points images;
  CHECK(CGAL::stretch_minimizing_volume_parameterization(soup, slice, images).status == VMP::OK);
  const std::string name = "mpi_" + std::to_string(size()) + "_<out> & \"in\"";
  const std::string victim = "mpi_" + std::to_string(size()) + "_victim.txt", link = name + "_0.vtu.tmp";
  if(rank() == 0) // a link that may stand for a temporary file
  {
    std::ofstream(victim) << "of somebody else";
    std::filesystem::remove(link);
    std::filesystem::create_symlink(victim, link);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  VMP::IO::write_PVTU(name + ".pvtu", soup, images);
  CHECK(text_of(victim) == "of somebody else");
  const std::string pvtu = text_of(name + ".pvtu");
  std::size_t number_of_cells = 0;
  for(int i = 0; i < size(); ++i)
  {
    CHECK(pvtu.find("<Piece Source=\"mpi_" + std::to_string(size()) + "_&lt;out&gt; &amp; &quot;in&quot;_" + std::to_string(i)
                    + ".vtu\"/>") != std::string::npos);
    const std::string vtu = text_of(name + "_" + std::to_string(i) + ".vtu");
    number_of_cells += std::stoul(vtu.substr(vtu.find("NumberOfCells=\"") + 15));
  }
  CHECK(number_of_cells == expected.soup.cells.size());
  CHECK_THROWS_AS(VMP::IO::write_PVTU("no/such/folder.pvtu", soup, images), std::runtime_error);
}

TEST_CASE("arrays of one process that do not fit together are not written by any")
{
  const Problem problem = problem_of(ring(4));
  const std::string name = "mpi_" + std::to_string(size()) + "_unfit.pvtu";
  const auto error_of_writing = [&](const auto& change)
  {
    Distributed_soup soup = problem.slice();
    Points images = soup.points;
    if(rank() == culprit())
      change(soup, images);
    std::string error;
    try { VMP::IO::write_PVTU(name, soup, images); } catch(const std::runtime_error& e) { error = e.what(); }
    CHECK(is_same_everywhere(error));
    CHECK_FALSE(std::filesystem::exists(name));
    CHECK_FALSE(std::filesystem::exists(VMP::IO::name_of_piece(name, rank())));
    return error;
  };
  CHECK(error_of_writing([](Distributed_soup&, Points& images) { images.clear(); }).find("an element for each point")
        != std::string::npos);
  CHECK(error_of_writing([](Distributed_soup&, Points& images) { images.emplace_back(); }).find("an element for each point")
        != std::string::npos);
  CHECK(error_of_writing([](Distributed_soup& soup, Points&) { soup.cell_references.clear(); })
        == "there is not one reference per cell");
  CHECK(error_of_writing([](Distributed_soup& soup, Points&) { soup.cells[0][2] = 1000; })
          .find(" has a vertex 1000 that does not exist") != std::string::npos);
}

TEST_CASE("what can be read does not depend on where a file is cut")
{
  const std::string mesh = "MeshVersionFormatted\n2\n\nDimension # three\n3\nVertices\n# none\n\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n"
                           "0 0 1 0\nTriangles\n0 Tetrahedra\n1\n1 2 3 4 7\nCorners\n1\n2\nEnd";
  std::istringstream is(mesh);
  Soup expected;
  VMP::IO::read_MEDIT(is, expected);
  for(const std::string& line : { std::string("#"), std::string("\n") })
    for(const int before : { 0, 1, 2, 5, 12, 40, 90 })
      for(const int behind : { 0, 1, 3, 20, 100, 180 })
      {
        const auto lines = [&](const int n) { return line + std::string(n, line[0]) + "\n"; };
        const std::string path = file("cut.mesh", lines(before) + mesh + "\n" + lines(behind));
        Distributed_soup soup;
        CHECK(error_of([&] { VMP::IO::read_MEDIT(path, soup); }) == "");
        CHECK(whole(soup.points) == expected.points);
        CHECK(whole(soup.cells) == expected.cells);
        CHECK(whole(soup.cell_references) == expected.cell_references);
      }
}

TEST_CASE("one process and several refuse the same files, with the same sentence")
{
  const std::string mesh = text_of(DATA "/cube.mesh"), targets = text_of(DATA "/cube_to_ball.txt");
  const std::string mark = "\xEF\xBB\xBF";
  const auto changed = [](std::string text, const std::string& from, const std::string& to)
  {
    return text.replace(text.rfind(from), from.size(), to);
  };
  const std::string harmless = changed(mesh, "\n", "\nx\n"); // an unknown keyword at the end is skipped
  for(const std::string& text : { harmless, mark + mesh, changed(mesh, "Formatted 2", "Formatted 4"),
        changed(mesh, "Formatted 2", "Formatted 5"), changed(mesh, "Dimension 3", "Dimension 2"),
        changed(mesh, "MeshV", "M"), changed(mesh, " 1\n", " 1.5\n"),
        changed(mesh, "Vertices\n", "Vertices\n1"), changed(mesh, "Tetrahedra\n", "Tetrahedra\n1"),
        changed(mesh, " 1\n", " 1\nTetrahedra 0\n"), changed(mesh, "End", "Vertices 0\nEnd"), "Vertices 0\n" + mesh,
        mesh + "\n7\n", mesh.substr(0, mesh.find("Tetra")),
        std::string("x"), std::string() })
  {
    const std::string path = file("bad.mesh", text);
    Distributed_soup soup;
    Soup serial;
    const std::string error = error_of([&] { VMP::IO::read_MEDIT(path, soup); });
    CHECK(error == error_of([&] { VMP::IO::read_MEDIT(path, serial); }));
    CHECK(whole(soup.cells) == serial.cells);
  }
  const std::string path = file("two_lines.mesh", changed(mesh, " 1\n", "\n1\n")); // for which several need one
  Distributed_soup soup;
  CHECK(error_of([&] { VMP::IO::read_MEDIT(path, soup); }).find(": the line ends where an integral") != std::string::npos);
  const std::string same_line = file("one_line.mesh", changed(mesh, " 1\n", " 1 1\n"));
  CHECK(error_of([&] { VMP::IO::read_MEDIT(same_line, soup); }).find("must have a line of its own") != std::string::npos);
  CHECK(error_of([&] { VMP::IO::read_MEDIT(DATA, soup); }) == DATA ": this is not a regular file, of which several "
                                                                  "processes can read a part each");
  CHECK(soup.cells.empty());

  Soup serial;
  VMP::IO::read_MEDIT(DATA "/cube.mesh", serial);
  VMP::IO::read_MEDIT(DATA "/cube.mesh", soup);
  for(const std::string& text : { targets + targets, targets + "7 1 2\n", targets + "7 1 2 x\n", targets + "7 1 2 3 4\n",
                                  targets + "1000 1 2 3\n", targets + "-1 1 2 3\n", targets + "7 1 2\n3\n", mark + targets })
  {
    Points points, expected;
    const std::string name = file("bad.txt", text);
    const std::string error = error_of([&] { VMP::IO::read_boundary_targets(name, soup, points); });
    CHECK(error == error_of([&] { VMP::IO::read_boundary_targets(name, serial, expected); }));
    CHECK(whole(points).size() == expected.size());
    CHECK(error.empty() == (text == mark + targets));
  }
}

// In each pair of cells, as many indices as in the other one are the same; so are the sums of their values.
TEST_CASE("a target with other cells is refused, whatever they have in common")
{
  Soup source, target;
  source.points.assign(9, {0, 0, 0});
  source.cells = { {0, 1, 4, 7}, {1, 2, 6, 8} };
  source.cell_references = { 0, 0 };
  target = source;
  target.cells = { {0, 1, 4, 8}, {1, 2, 6, 7} };
  std::ostringstream os, other;
  VMP::IO::write_MEDIT(os, source);
  VMP::IO::write_MEDIT(other, target);
  const std::string path = file("source.mesh", os.str()), name = file("target.mesh", other.str());
  Distributed_soup soup;
  VMP::IO::read_MEDIT(path, soup);
  Points points;
  CHECK(error_of([&] { VMP::IO::read_boundary_targets(name, soup, points); })
        == name + ": the cells of the target join other vertices than those of the source");
  std::swap(soup.cells.empty() ? target.cells[0][0] : soup.cells[0][0],
            soup.cells.empty() ? target.cells[0][1] : soup.cells[0][3]);
  CHECK(error_of([&] { VMP::IO::read_boundary_targets(path, soup, points); }) == ""); // in another order
}

TEST_CASE("reading ends in all processes if it does in one")
{
  struct Visitor_of_culprit
  {
    bool after_step(const VMP::Parameterization_step&) { return true; }
    bool goes_on() { return rank() != culprit(); }
  };
  Distributed_soup soup;
  Points points;
  const auto np = params::visitor(Visitor_of_culprit());
  CHECK_FALSE(VMP::IO::read_MEDIT(DATA "/cube.mesh", soup, np));
  CHECK(soup.cells.empty());
  CHECK(VMP::IO::read_MEDIT(DATA "/cube.mesh", soup));
  CHECK_FALSE(VMP::IO::read_boundary_targets(DATA "/cube_to_ball.txt", soup, points, np));
  CHECK_FALSE(VMP::IO::read_boundary_targets(DATA "/cube.mesh", soup, points,
                                             params::maximum_running_time(rank() == culprit() ? 0. : 1e9)));
  CHECK(points.empty());
}

TEST_CASE("what MPI cannot count is refused")
{
  constexpr std::uint64_t largest = (std::numeric_limits<int>::max)();
  using VMP::internal::MPI_communicator_3;
  CHECK(MPI_communicator_3::begins_of({ 3, largest - 3 }) == std::vector<int>{ 0, 3, static_cast<int>(largest) });
  CHECK_THROWS_AS(MPI_communicator_3::begins_of({ 3, largest - 2 }), std::runtime_error);
  CHECK_THROWS_AS(MPI_communicator_3::begins_of({ largest + 4, largest }), std::runtime_error);
}

TEST_CASE("the environment is the user's")
{
  const Problem problem = problem_of(ring(4));
  unsetenv("SCOTCH_PTHREAD_NUMBER");
  CHECK(end_of(problem.slice(), problem.slice_of_targets(), params::number_of_iterations(5)) != "");
  CHECK(std::getenv("SCOTCH_PTHREAD_NUMBER") == nullptr);
  setenv("SCOTCH_PTHREAD_NUMBER", "1", 1);
}

int main(int argc, char* argv[])
{
  setenv("SCOTCH_PTHREAD_NUMBER", "1", 1); // PT-Scotch with threads would find another partition in each run
  PetscInitialize(nullptr, nullptr, nullptr, nullptr);
  const int failures = Catch::Session().run(argc, argv);
  PetscFinalize();
  return failures != 0;
}
