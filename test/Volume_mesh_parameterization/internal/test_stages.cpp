// The stages with fixed boundary: untangling, then minimization, and where this ends.
#include "catch.h"
#include "map_checks.h"

#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_body_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Staged_targets_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/minimize_map_3.h>
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
#  include <CGAL/Volume_mesh_parameterization/CHOLMOD_solver_traits_3.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

TEST_CASE("The identity and affine maps are recovered on cells of equal volume")
{
  Matrix3d A;
  A << 2, 0.3, 0.1, -0.4, 1, 0.2, 0.5, -0.1, 0.7;
  const Vector3d b(10, -20, 30);
  for(const int n : {2, 3, 4, 6})
    for(const Matrix3d& linear : {Matrix3d(Matrix3d::Identity()), A, Matrix3d(1e-5 * A), Matrix3d(1e5 * A)})
    {
      const auto affine = [&](const Vector3d& p) -> Vector3d { return linear * p + linear.norm() * b; };
      const Numbered_mesh_3 mesh = mapped_cube(n, 0, affine);
      const Outcome outcome = run(mesh);
      CHECK(outcome.status == VMP::OK);
      const Matrix3Xd expected = (linear * mesh.source).colwise() + linear.norm() * b;
      CHECK((outcome.positions - expected).colwise().norm().maxCoeff() <= 1e-6 * linear.norm());
      CHECK(has_target_boundary(mesh, outcome.positions));
    }
}

TEST_CASE("The minimizer returns to the identity from a perturbed start")
{
  const Numbered_mesh_3 mesh = cube_mesh(5);
  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  const VMP::internal::Scaled_cells_3 scaled{1, inverse_sources(mesh), std::vector<double>(mesh.cells.size(), 1.)};
  VMP::internal::Newton_system_3 system(mesh, scaled, free_vertices(mesh), linear_solver);
  const VMP::Stretch_energy_3 stretch;
  const VMP::internal::Cell_energy_of<VMP::Stretch_energy_3> energy(stretch);
  Matrix3Xd u = mesh.source;
  u.leftCols(mesh.number_of_free_vertices) += noise(mesh.number_of_free_vertices, 0.2);
  REQUIRE(number_of_inverted_cells(mesh, u) == 0);

  VMP::internal::Progress_3 progress(VMP::internal::Budget(), 50);
  const VMP::internal::Newton_result_3 result = minimize_energy_3(system, energy, u, progress);
  CHECK(result.status == VMP::OK);
  CHECK((result.positions - mesh.source).cwiseAbs().maxCoeff() <= 1e-5);
}

TEMPLATE_TEST_CASE("The energy never rises, and no cell is ever inverted", "",
                   VMP::Stretch_energy_3, VMP::Dirichlet_energy_3)
{
  const TestType energy;
  for(const Numbered_mesh_3& mesh : {twisted_cube(5, 0.15), ring(6)})
  {
    Solver<> solver;
    const Outcome whole = fixed_boundary::run(mesh, energy, solver);
    double previous = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < whole.steps.size(); ++i)
    {
      if(whole.steps[i].phase == VMP::Phase::UNTANGLING)
        continue;
      CHECK(whole.steps[i].energy <= previous);
      CHECK(whole.steps[i].number_of_inverted_cells == 0);
      previous = whole.steps[i].energy;
      if(i % 4 != 0)
        continue;
      const Outcome part = fixed_boundary::run(mesh, energy, solver, i + 1); // ends after this step
      CHECK(part.energy == whole.steps[i].energy);
      CHECK(number_of_inverted_cells(mesh, part.positions) == 0);
    }
    if(energy.value(Vector3d(1, 1, 1e-9)) > 1e6) // a barrier against flat cells
      CHECK(whole.status == VMP::OK);
    CHECK(previous == Approx(mean_energy(energy, mesh, whole.positions)).epsilon(1e-9));
    CHECK(has_target_boundary(mesh, whole.positions));
  }
}

TEST_CASE("The result is a minimum")
{
  const Numbered_mesh_3 mesh = twisted_cube(4, 0.15);
  const VMP::Stretch_energy_3 energy;
  const Outcome outcome = run(mesh);
  REQUIRE(outcome.status == VMP::OK);
  for(const double amplitude : {0.001, 0.01, 0.05})
    for(unsigned int seed = 0; seed < 5; ++seed)
    {
      Matrix3Xd u = outcome.positions;
      u.leftCols(mesh.number_of_free_vertices) += noise(mesh.number_of_free_vertices, amplitude, seed);
      CHECK(mean_energy(energy, mesh, u) > outcome.energy);
    }
}

TEST_CASE("Without free vertices the map is the target")
{
  const Numbered_mesh_3 mesh = twisted_cube(1);
  REQUIRE(mesh.number_of_free_vertices == 0);
  const Outcome outcome = run(mesh);
  CHECK(outcome.status == VMP::OK);
  CHECK(has_same_bits(outcome.positions, mesh.target));
}

TEST_CASE("A negative zero among the targets stays one")
{
  const Numbered_mesh_3 mesh = mapped_cube(3, 0, [](const Vector3d& p) { return Vector3d(-p[0], -p[1], p[2]); });
  CHECK(has_target_boundary(mesh, run(mesh).positions));
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("Parallel and sequential results have the same bits")
{
  for(Numbered_mesh_3 mesh : {twisted_cube(10, 0.1), ring(10)})
  {
    const VMP::Stretch_energy_3 energy;
    const Outcome sequential = run(mesh);
    mesh.is_parallel = true;
    const Outcome parallel = run(mesh, energy, Solver<CGAL::Parallel_tag>());
    CHECK(sequential.status == VMP::OK);
    CHECK(has_same_bits(sequential.positions, parallel.positions));
    CHECK(sequential.energy == parallel.energy);
  }
}
#endif

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
TEST_CASE("Both solvers lead to the same minimum")
{
  const VMP::Stretch_energy_3 energy;
  for(const Numbered_mesh_3& mesh : {twisted_cube(6, 0.1), ring(6)})
  {
    const Outcome iterative = run(mesh);
    const Outcome direct = run(mesh, energy, VMP::CHOLMOD_solver_traits_3());
    CHECK(direct.status == VMP::OK);
    CHECK(direct.energy == Approx(iterative.energy).epsilon(1e-6));
    CHECK((direct.positions - iterative.positions).cwiseAbs().maxCoeff() <= 1e-3);
  }
}
#endif

namespace {

// A step that has led to this energy, where the squared decrement was that.
VMP::internal::Newton_iterate_3 iterate_of(const double energy, const double squared_decrement)
{
  VMP::internal::Newton_iterate_3 result;
  result.evaluation.energy = energy;
  result.direction.slope = -squared_decrement;
  return result;
}

} // namespace

TEST_CASE("A minimization stagnates where neither the energy nor the decrement falls")
{
  const Numbered_mesh_3 mesh = cube_mesh(2);
  const VMP::internal::Cell_energy_of<VMP::Stretch_energy_3> energy{VMP::Stretch_energy_3()};
  const auto is_noticed = [&](const double energy_rate, const double decrement_rate)
  {
    VMP::internal::Gain_3 gain(mesh, energy, 1e-3);
    bool result = false;
    for(int i = 0; i < 100; ++i)
      result = gain.is_stagnating(iterate_of(1000 * std::pow(energy_rate, i), std::pow(decrement_rate, i))) || result;
    return result;
  };
  CHECK(is_noticed(0.99995, 1));
  CHECK(is_noticed(0.99995, 0.9));
  CHECK(!is_noticed(0.99995, 0.6)); // near a minimum
  CHECK(!is_noticed(0.9995, 1));
}

TEST_CASE("A search crawls where a few cells hold most of the energy, and it falls for them alone")
{
  // In ten steps, the first cell becomes higher by a tenth, and all of the mesh by the rate.
  const Numbered_mesh_3 mesh = cube_mesh(6);
  const VMP::internal::Cell_energy_of<VMP::Stretch_energy_3> energy{VMP::Stretch_energy_3()};
  const auto first_notice = [&](const double first_height, const double rate, const bool is_stagnating)
  {
    VMP::internal::Gain_3 gain(mesh, energy, 1e-3);
    for(int step = 1; step <= 300; ++step)
    {
      const double rounds = static_cast<double>(step) / 10;
      Matrix3Xd image = mesh.source;
      const Vector3d a = image.col(mesh.cells[0][0]), b = image.col(mesh.cells[0][1]);
      const Vector3d normal = (image.col(mesh.cells[0][2]) - b).cross(image.col(mesh.cells[0][3]) - b).normalized();
      image.col(mesh.cells[0][0]) -= (1 - first_height * std::pow(1.1, rounds)) * normal.dot(a - b) * normal;
      image.row(2) *= 0.1 * std::pow(rate, rounds);
      const double falling = is_stagnating ? 1 : std::pow(0.999, step);
      VMP::internal::Newton_iterate_3 iterate = iterate_of(2 * VMP::internal::Gain_3::large_energy * falling, 1);
      iterate.u = image;
      if(const std::optional<VMP::Error_code> status = gain.status_of_end(iterate))
        return status == VMP::OK ? -step : step; // negative if nothing is gained for any cell
    }
    return 0;
  };
  CHECK(first_notice(1e-5, 1, false) == 105);
  CHECK(first_notice(1e-5, 0.99, false) == 105); // the others become worse
  CHECK(first_notice(1e-5, 1.01, false) == 0);   // or better
  CHECK(first_notice(1e-5, 1.01, true) == 10);   // the first five steps have nothing to be compared with
  CHECK(first_notice(0.05, 1, true) == -10);     // no cell holds most of the energy
  CHECK(first_notice(0.05, 1, false) == 0);
}

TEST_CASE("A cell that the boundary makes flat does not keep the other vertices from their minimum")
{
  // a facet of the boundary becomes flat, and its cell holds all of the energy, wherever its free vertex is
  Numbered_mesh_3 mesh = cube_mesh(5, 0.15);
  const Matrix3Xd grid = cube_mesh(5).source;
  const auto vertex_at = [&](const Vector3d& p)
  {
    Eigen::Index v = 0;
    (grid.colwise() - p).colwise().norm().minCoeff(&v);
    return static_cast<int>(v);
  };
  const int moved = vertex_at({ 1, 1, 0 });
  mesh.target.col(moved) = Vector3d(1, 1e-5, 0);
  Matrix3Xd start = grid;
  start.col(moved) = mesh.target.col(moved);
  REQUIRE(number_of_inverted_cells(mesh, start) == 0);

  const VMP::Stretch_energy_3 stretch;
  Solver<> solver;
  fixed_boundary::Problem<VMP::Stretch_energy_3, Solver<> > problem(mesh, stretch, solver);
  const auto far_from_minimum = [&](const Matrix3Xd& u, const int v) // the gradient of its cells by a free vertex
  {
    Vector3d gradient = Vector3d::Zero();
    for(const std::array<int, 4>& cell : mesh.cells)
      if(std::find(cell.begin(), cell.end(), v) != cell.end())
        for(int i = 0; i < 3; ++i)
        {
          constexpr double h = 1e-6;
          Matrix3Xd right = u, left = u;
          right(i, v) += h;
          left(i, v) -= h;
          gradient[i] += (psi(stretch, mesh, right, cell) - psi(stretch, mesh, left, cell)) / (2 * h);
        }
    return gradient.norm();
  };
  const int far = vertex_at({ 4, 4, 4 }), center = vertex_at({ 3, 2, 3 });
  REQUIRE(far_from_minimum(start, far) > 0.5);

  VMP::internal::Found_map_3 found;
  found.map = evaluated_map(mesh, start);
  found.status = VMP::OK;
  VMP::internal::Progress_3 progress = patient_progress();
  VMP::internal::Map_options_3 options;
  options.energy_tolerance = 0; // to the minimum
  found = minimize_map_3(problem.system, { options, problem.energy, problem.solver, progress }, found);
  CHECK(found.map.is_solution());
  CHECK(far_from_minimum(found.map.positions, far) < 0.05);
  CHECK(far_from_minimum(found.map.positions, center) < 0.05);

  progress.begin_stage();
  const Matrix3Xd whole = minimize_energy_3(problem.system, problem.energy, start, progress).positions;
  CHECK(far_from_minimum(whole, far) > 0.05);

  const VMP::internal::Dominant_cells_3 dominant = dominant_cells_3(mesh, problem.energy, found.map.positions);
  CHECK(dominant.part_of_energy > 0.99);
  REQUIRE(!dominant.cells.empty());
  CHECK(dominant.cells.size() < 10);
  for(const std::size_t c : dominant.cells)
    CHECK(std::find(mesh.cells[c].begin(), mesh.cells[c].end(), moved) != mesh.cells[c].end());
  CHECK(dominant_cells_3(mesh, problem.energy, mesh.source).cells.empty());
}

TEST_CASE("Targets that move like one rigid body go along arcs, also where no edges connect their vertices")
{
  const VMP::Tetrahedron_soup_3 soup = source_soup(cube_mesh(6, 0));
  std::vector<std::array<double, 3> > targets = soup.points;
  std::vector<bool> is_prescribed(targets.size());
  const auto turned = [](const double x, const double angle)
  { return Vector3d(1 + (x - 1) * std::cos(angle), 3 + (x - 1) * std::sin(angle), 3); };
  constexpr double angle = 5 * CGAL_PI / 6;
  for(std::size_t v = 0; v < targets.size(); ++v)
    if(const auto [x, y, z] = targets[v]; y == 3 && z == 3 && (x == 1 || x == 3 || x == 5))
    {
      is_prescribed[v] = true;
      targets[v] = { turned(x, angle)[0], turned(x, angle)[1], 3 };
    }
  const auto body = VMP::internal::body_of(soup.points, soup.cells);
  Numbered_mesh_3 mesh = VMP::internal::Numbered_body_3(body, is_prescribed, targets).mesh;
  mesh.alignment.emplace();
  const VMP::internal::Staged_targets_3 staged(mesh);
  CHECK(staged.number_of_stages() == 10);
  for(const double part : { 0.2, 0.5, 1. })
  {
    const Numbered_mesh_3 at_part = staged.mesh_at(part);
    for(int v = mesh.number_of_free_vertices; v < mesh.number_of_vertices(); ++v)
      CHECK((Vector3d(at_part.target.col(v)) - turned(mesh.source(0, v), part * angle)).norm() < 1e-8);
  }
}
