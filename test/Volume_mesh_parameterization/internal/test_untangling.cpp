// Untangling: of the whole mesh, of patches of it, and splits of edges where it is stuck.
#include "catch.h"
#include "map_checks.h"

#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/find_splits_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/untangle_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Untangling/untangle_patches_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

TEST_CASE("A map with inverted cells is untangled")
{
  const Numbered_mesh_3 mesh = ring(8);
  Solver<> solver;
  fixed_boundary::Problem<VMP::Stretch_energy_3, Solver<> > problem(mesh, VMP::Stretch_energy_3(), solver);
  const Matrix3Xd start = fixed_boundary::harmonic_start(mesh, problem.system);
  CHECK(number_of_inverted_cells(mesh, start) > 100);
  for(const std::size_t limit : { 1, 1000 })
  {
    std::size_t last_number = number_of_inverted_cells(mesh, start), number_of_steps = 0;
    VMP::internal::Progress_3 progress(VMP::internal::Budget(), limit, [&](const VMP::Parameterization_step& step)
    {
      CHECK(last_number > 0);
      CHECK(step.phase == VMP::Phase::UNTANGLING);
      CHECK(step.kind == VMP::Step_kind::NEWTON);
      CHECK(step.decrement > 0);
      last_number = step.number_of_inverted_cells;
      ++number_of_steps;
      return true;
    });
    const VMP::internal::Newton_result_3 result
      = minimize_untangling_energy_3(problem.system, start, fixed_boundary::theta, progress);
    CHECK(has_target_boundary(mesh, result.positions));
    CHECK(result.status == (limit == 1000 ? VMP::OK : VMP::ERROR_NOT_FLIP_FREE));
    CHECK((number_of_inverted_cells(mesh, result.positions) == 0) == (limit == 1000));
    CHECK((number_of_steps == limit) == (limit < 1000));
  }
}

TEST_CASE("All free vertices of a cube leave the point where they start, without a split")
{
  const Numbered_mesh_3 mesh = cube_mesh(5);
  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  VMP::internal::Progress_3 progress(VMP::internal::Budget(), 1000);
  const VMP::internal::Expansion_result_3 result = expand_core_3(mesh, false, linear_solver, progress);
  CHECK(result.images.status == VMP::OK);
  CHECK(result.edges.empty());
  CHECK(has_target_boundary(mesh, result.images.positions));
  CHECK(number_of_inverted_cells(mesh, result.images.positions) == 0);
}

TEST_CASE("No vertex leaves a point that does not see all of the boundary")
{
  const Numbered_mesh_3 mesh = ring(8);
  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  VMP::internal::Progress_3 progress(VMP::internal::Budget(), 1000);
  CHECK(expand_core_3(mesh, true, linear_solver, progress).images.status == VMP::ERROR_NOT_FLIP_FREE);
  CHECK(progress.number_of_steps() == 0);
}

TEST_CASE("A split edge of the core keeps the volume of all open cells")
{
  const Numbered_mesh_3 mesh = cube_mesh(3);
  VMP::internal::Core_map_3 core(mesh, VMP::internal::Vector_3(1.4, 1.5, 1.6));
  const auto volume_of_open_cells = [&]
  {
    double sum = 0;
    for(int v = 0; v < core.number_of_vertices(); ++v)
      for(const auto& side : core.sides(v))
        if(core.is_open(side.cell))
          sum += core.volume(side.cell) / 4; // which each of four vertices has
    return sum;
  };
  const double before = volume_of_open_cells();
  CHECK(before == Approx(6 * volume(mesh, mesh.target)));
  for(const int w : core.neighbors(0))
    if(core.is_prescribed(w))
      core.split(0, w);
  REQUIRE(core.splits().size() > 3);
  CHECK(volume_of_open_cells() == Approx(before));
}

TEST_CASE("A patch puts back a vertex that was drawn out of its ring, and moves no other vertex but its neighbors")
{
  const Numbered_mesh_3 mesh = cube_mesh(8);
  const auto [v, far] = middle_and_corner(mesh);
  Matrix3Xd start = mesh.source;
  start.col(v) += Vector3d(1.7, 0.3, 0.2);
  const std::size_t inverted = number_of_inverted_cells(mesh, start);
  REQUIRE(inverted > 0);

  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  std::size_t number_of_steps = 0;
  VMP::internal::Progress_3 progress(VMP::internal::Budget(), 1000, [&](const VMP::Parameterization_step& step)
  {
    CHECK(step.kind == VMP::Step_kind::PATCH);
    CHECK(step.number_of_inverted_cells <= inverted);
    ++number_of_steps;
    return true;
  });
  const VMP::internal::Newton_result_3 result = untangle_patches_3(mesh, linear_solver, start, progress);
  CHECK(number_of_steps > 0);
  CHECK(result.status == VMP::OK);
  CHECK(number_of_inverted_cells(mesh, result.positions) == 0);
  CHECK(result.positions.col(far) == start.col(far));
  CHECK(has_target_boundary(mesh, result.positions));
}

TEST_CASE("Patches leave a map without inverted cells as it is, and end where there is none")
{
  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  Numbered_mesh_3 mesh = cube_mesh(3);
  VMP::internal::Progress_3 progress = patient_progress();
  const VMP::internal::Newton_result_3 done = untangle_patches_3(mesh, linear_solver, mesh.source, progress);
  CHECK(done.status == VMP::OK);
  CHECK(progress.number_of_steps() == 0);
  CHECK(done.positions == mesh.source);

  // two neighbors within a face of the boundary change their places
  const auto vertex_at = [&](const Vector3d& p)
  {
    Eigen::Index v = 0;
    (mesh.source.colwise() - p).colwise().norm().minCoeff(&v);
    return v;
  };
  std::swap(mesh.target.col(vertex_at({ 1, 1, 0 })), mesh.target.col(vertex_at({ 2, 1, 0 })));
  const Matrix3Xd start = snapped(mesh, mesh.source);
  const VMP::internal::Newton_result_3 stuck = untangle_patches_3(mesh, linear_solver, start, progress);
  CHECK(stuck.status == VMP::ERROR_NOT_FLIP_FREE);
  CHECK(number_of_inverted_cells(mesh, stuck.positions) > 0);
  CHECK(number_of_inverted_cells(mesh, stuck.positions) <= number_of_inverted_cells(mesh, start));
}

namespace {

// All cells of a prism over an octagon meet in a vertex in its middle. Its target is a prism over a U, where no point sees
// the inner walls of both arms, so that this vertex has no place.
Numbered_mesh_3 prism_to_U()
{
  constexpr int n = 8;
  constexpr double U[n][2] = { {0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2} };
  constexpr int triangles[n - 2][3] = { {0, 1, 4}, {0, 4, 5}, {1, 2, 4}, {2, 3, 4}, {0, 5, 7}, {5, 6, 7} };
  Numbered_mesh_3 mesh;
  mesh.number_of_free_vertices = 1;
  mesh.source.setZero(3, 1 + 2 * n);
  mesh.target.setZero(3, 1 + 2 * n);
  for(int i = 0; i < n; ++i)
    for(int z = 0; z < 2; ++z)
    {
      const double angle = (2 * i + 1) * 3.14159265358979 / n;
      mesh.source.col(1 + i + n * z) = Vector3d(std::cos(angle), std::sin(angle), z - 0.5);
      mesh.target.col(1 + i + n * z) = Vector3d(U[i][0], U[i][1], z);
    }
  const auto add_cell = [&](const int a, const int b, const int c) { mesh.cells.push_back({ 0, 1 + a, 1 + b, 1 + c }); };
  for(const auto& [a, b, c] : triangles)
  {
    add_cell(a, b, c);
    add_cell(n + a, n + c, n + b);
  }
  for(int i = 0; i < n; ++i)
  {
    const int j = (i + 1) % n;
    add_cell(i, n + j, j);
    add_cell(i, n + i, n + j);
  }
  for(std::array<int, 4>& cell : mesh.cells) // seen from outside so far
    std::swap(cell[2], cell[3]);
  return mesh;
}

} // namespace

TEST_CASE("Of many items only those are kept that are needed, with few questions")
{
  for(const std::vector<int>& needed : { std::vector<int>{ 3, 17, 64 }, std::vector<int>{ 99 }, std::vector<int>{ 0, 1 } })
  {
    std::vector<int> items(100);
    std::iota(items.begin(), items.end(), 0);
    int number_of_questions = 0;
    VMP::internal::leave_out_unneeded(items.size(), [&](const std::size_t first, const std::size_t number)
    {
      std::vector<int> others = items;
      others.erase(others.begin() + first, others.begin() + first + number);
      REQUIRE(!others.empty());
      ++number_of_questions;
      const bool suffice = std::includes(others.begin(), others.end(), needed.begin(), needed.end());
      if(suffice)
        items = others;
      return suffice;
    });
    CHECK(items == needed);
    CHECK(number_of_questions < 60);
  }
  int number_of_questions = 0;
  VMP::internal::leave_out_unneeded(1, [&](std::size_t, std::size_t) { return ++number_of_questions > 0; });
  CHECK(number_of_questions == 0); // one is kept
}

TEST_CASE("Cells around split edges are halved")
{
  Numbered_mesh_3 mesh = cube_mesh(3);
  const std::size_t number_of_cells = mesh.cells.size();
  const int number_of_free_vertices = mesh.number_of_free_vertices;
  const std::array<int, 4> cell = mesh.cells[100];
  const std::vector<std::array<int, 2> > edges = { { cell[0], cell[1] }, { cell[2], cell[3] }, { cell[3], cell[0] } };
  Matrix3Xd image = 2 * mesh.source;
  const double volume = VMP::internal::volume(mesh, mesh.source);
  split_patch_edges_3(mesh, image, edges);
  CHECK(mesh.number_of_free_vertices == number_of_free_vertices + 3);
  CHECK(image == 2 * mesh.source);
  CHECK(mesh.cells.size() >= number_of_cells + 3);
  CHECK(number_of_inverted_cells(mesh, mesh.source) == 0);
  CHECK(VMP::internal::volume(mesh, mesh.source) == Approx(volume));
  for(int i = 0; i < 3; ++i)
    CHECK(std::any_of(mesh.cells.begin(), mesh.cells.end(), [&](const std::array<int, 4>& c)
                      { return std::find(c.begin(), c.end(), number_of_free_vertices + i) != c.end(); }));
}

TEST_CASE("Of two split edges of a facet the longer one is split first, as in a body")
{
  Numbered_mesh_3 mesh;
  mesh.number_of_free_vertices = 4;
  mesh.source.resize(3, 4);
  mesh.source << 0, 1, 0, 0,
                 0, 0, 2, 0,
                 0, 0, 0, 1;
  mesh.target = mesh.source;
  mesh.cells = { { 0, 1, 2, 3 } };
  Matrix3Xd image = mesh.source;
  split_patch_edges_3(mesh, image, { { 0, 1 }, { 0, 2 } });
  const auto is_edge = [&](const int v, const int w)
  {
    return std::any_of(mesh.cells.begin(), mesh.cells.end(), [&](const std::array<int, 4>& c)
    { return std::count(c.begin(), c.end(), v) + std::count(c.begin(), c.end(), w) == 2; });
  };
  CHECK(mesh.cells.size() == 3);
  CHECK(is_edge(5, 1)); // from the middle of the longer edge
  CHECK(!is_edge(4, 2));
}

TEST_CASE("Further attempts are in vain where few cells are left and a proof tells that they cannot be mended")
{
  using namespace VMP::internal;
  Solver<> solver;
  Linear_solver_of<Solver<> > linear_solver(solver);
  Progress_3 progress = patient_progress();
  Numbered_mesh_3 mesh = prism_to_U();
  Matrix3Xd start = mesh.target;
  start.col(0) = Vector3d(1.5, 0.5, 0.5);
  {
    Newton_system_3 system(mesh, free_vertices(mesh), linear_solver);
    Untangling_search_3 search(system, evaluated_map(mesh, start), progress, false);
    search.untangle(untangling_attempts[0], start);
    REQUIRE(search.is_unsolved());
    CHECK(search.is_in_vain());
  }
  mesh.target = mesh.source; // there is a map, wherever the search is
  start = mesh.target;
  start.col(0) = Vector3d(5, 0, 0);
  REQUIRE(number_of_inverted_cells(mesh, start) > 0);
  Newton_system_3 system(mesh, free_vertices(mesh), linear_solver);
  CHECK(!Untangling_search_3(system, evaluated_map(mesh, start), progress, false).is_in_vain());
}

namespace {

// A cube with a corner, the origin, that is drawn beyond the opposite one; or with the middle of its top below its bottom.
Numbered_mesh_3 tangled_cube(const bool has_few_inverted_cells)
{
  Numbered_mesh_3 mesh = cube_mesh(3);
  const double size = mesh.source.maxCoeff();
  for(int v = mesh.number_of_free_vertices; v < mesh.number_of_vertices(); ++v)
  {
    const Vector3d p = mesh.source.col(v);
    const bool is_in_middle = p[2] == size && p.head(2).minCoeff() > 0 && p.head(2).maxCoeff() < size;
    if(has_few_inverted_cells && p.isZero())
      mesh.target.col(v) = Vector3d::Constant(1.5 * size);
    else if(!has_few_inverted_cells && is_in_middle)
      mesh.target(2, v) = -0.5 * size;
  }
  return mesh;
}

struct Attempts
{
  std::set<std::string> at_whole_mesh;
  std::size_t number_at_patches = 0, number_at_splits = 0;
  VMP::internal::Found_map_3 found;
};

// Untangles from images.
Attempts attempts_at(const Numbered_mesh_3& mesh, const Matrix3Xd& start, const bool may_split)
{
  using namespace VMP::internal;
  Solver<> solver;
  Linear_solver_of<Solver<> > linear_solver(solver);
  Newton_system_3 system(mesh, free_vertices(mesh), linear_solver);
  Attempts result;
  Progress_3 progress(Budget(), 1000, [&](const VMP::Parameterization_step& step)
  {
    if(step.kind == VMP::Step_kind::NEWTON)
      result.at_whole_mesh.insert(step.attempt);
    result.number_at_patches += step.kind == VMP::Step_kind::PATCH;
    result.number_at_splits += step.kind == VMP::Step_kind::SPLIT;
    return true;
  });
  result.found = untangle_map_3(system, evaluated_map(mesh, start), start, may_split, progress);
  CHECK(result.found.status == VMP::ERROR_NOT_FLIP_FREE);
  return result;
}

} // namespace

TEST_CASE("Few cells that no map can mend are left to splits at once; patches grow where these are not allowed")
{
  const Numbered_mesh_3 mesh = prism_to_U();
  Matrix3Xd start = mesh.target;
  start.col(0) = Vector3d(1.5, 0.5, 0.5);
  for(const bool may_split : {false, true})
  {
    const Attempts attempts = attempts_at(mesh, start, may_split);
    CHECK(attempts.at_whole_mesh.empty());
    CHECK(attempts.number_at_patches == (may_split ? 2 : 4)); // of as many rings
    CHECK(attempts.found.is_stuck() == may_split);
    CHECK(attempts.found.splits.edges.empty() == !may_split);
  }
}

TEST_CASE("Where no splits are found, untangling goes on with the next attempt, and makes no attempt at a patch twice")
{
  for(const bool has_few_inverted_cells : {false, true})
    for(const bool may_split : {false, true})
    {
      const Numbered_mesh_3 mesh = tangled_cube(has_few_inverted_cells);
      const Attempts attempts = attempts_at(mesh, snapped(mesh, mesh.source), may_split);
      const std::size_t number_of_rounds = has_few_inverted_cells ? 2 : 1; // attempts that left few cells to patches go on
      CHECK(attempts.at_whole_mesh.size() == number_of_rounds * VMP::internal::untangling_attempts.size());
      CHECK(!attempts.found.is_stuck());
      const std::size_t number_of_rings = 3;
      CHECK(attempts.number_at_splits == (may_split ? number_of_rings * VMP::internal::patch_attempts().size() : 0));
    }
}

namespace {

// Splits the edges of a mesh, and returns the images that were found for it then.
Matrix3Xd split(Numbered_mesh_3& mesh, const VMP::internal::Splits_3& splits)
{
  const int n = mesh.number_of_free_vertices;
  Matrix3Xd image = splits.positions;
  split_patch_edges_3(mesh, image, splits.edges);
  REQUIRE(splits.new_images.size() == splits.edges.size());
  for(std::size_t i = 0; i < splits.edges.size(); ++i)
    image.col(n + i) = splits.new_images[i];
  return image;
}

} // namespace

TEST_CASE("Where a vertex has no place, some of the edges at it are split, and then all vertices have one")
{
  Numbered_mesh_3 mesh = prism_to_U();
  REQUIRE(number_of_inverted_cells(mesh, mesh.source) == 0);
  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  Matrix3Xd image = mesh.target;
  image.col(0) = Vector3d(1.5, 0.5, 0.5);
  image = untangled_patch_3(mesh, linear_solver, image, VMP::internal::Budget());
  REQUIRE(number_of_inverted_cells(mesh, image) > 0);

  VMP::internal::Progress_3 progress = patient_progress();
  const VMP::internal::Splits_3 splits = find_splits_3(mesh, linear_solver, evaluated_map(mesh, image), progress);
  CHECK(splits.edges.size() >= 2); // an arm needs a vertex at its inner wall for its upper and one for its lower half
  CHECK(splits.edges.size() <= 8); // there are 16
  image = split(mesh, splits);
  CHECK(number_of_inverted_cells(mesh, image) == 0);
  CHECK(has_target_boundary(mesh, image));
}

TEST_CASE("A search for splits that is ended after the first attempt that helps splits all edges, and asks no more")
{
  Numbered_mesh_3 mesh = prism_to_U();
  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  Matrix3Xd image = mesh.target;
  image.col(0) = Vector3d(1.5, 0.5, 0.5);
  image = untangled_patch_3(mesh, linear_solver, image, VMP::internal::Budget());
  std::size_t number_of_edges = 0;
  for(std::size_t last = 1; number_of_edges == 0; ++last)
  {
    REQUIRE(last < 20);
    std::size_t number_of_attempts = 0;
    VMP::internal::Budget budget;
    VMP::internal::Progress_3 progress(budget, 1000, [&](const auto&) { return ++number_of_attempts < last; });
    number_of_edges = find_splits_3(mesh, linear_solver, evaluated_map(mesh, image), progress).edges.size();
  }
  CHECK(number_of_edges == 16);
}

TEST_CASE("Attempts to do without splits end if they have more cells than they may")
{
  const Numbered_mesh_3 mesh = prism_to_U();
  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  Matrix3Xd image = mesh.target;
  image.col(0) = Vector3d(1.5, 0.5, 0.5);
  image = untangled_patch_3(mesh, linear_solver, image, VMP::internal::Budget());
  VMP::internal::Patch_3 whole = { { 0 }, {} };
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
    whole.cells.push_back(c);
  const VMP::internal::Patch_mesh_3 patch(mesh, image, whole);
  std::vector<std::size_t> numbers_of_attempts, numbers_of_edges;
  for(const std::size_t number_of_cells : { std::size_t(0), 3 * mesh.cells.size(), 1000 * mesh.cells.size() })
  {
    std::size_t number_of_attempts = 0;
    const auto splits = splits_of_patch_3(patch, linear_solver, true, number_of_cells, VMP::internal::Budget(),
                                          [&] { return ++number_of_attempts > 0; });
    REQUIRE(splits);
    numbers_of_attempts.push_back(number_of_attempts);
    numbers_of_edges.push_back(splits->edges.size());
  }
  CHECK(numbers_of_attempts[0] < numbers_of_attempts[1]);
  CHECK(numbers_of_attempts[1] <= numbers_of_attempts[0] + 3);
  CHECK(numbers_of_attempts[1] < numbers_of_attempts[2]);
  CHECK(numbers_of_edges[0] >= numbers_of_edges[1]);
  CHECK(numbers_of_edges[0] > numbers_of_edges[2]);
}

TEST_CASE("An edge between prescribed vertices is split where it leaves the target, although no free vertex is at it")
{
  // An octahedron around its axis, the edge of vertices 1 and 2; its lower half is filled from the vertex 0. Its lowest
  // vertex goes up above the axis.
  Numbered_mesh_3 mesh;
  mesh.number_of_free_vertices = 1;
  mesh.source.resize(3, 7);
  mesh.source << 0, -1, 1, 0, 0, 0, 0,
                 0, 0, 0, -1, 1, 0, 0,
                 -0.5, 0, 0, 0, 0, 1, -1;
  mesh.target = mesh.source;
  mesh.target.col(0) = Vector3d::Zero();
  mesh.target(2, 6) = 0.3;
  mesh.cells = { { 1, 2, 4, 5 }, { 1, 3, 2, 5 }, { 1, 4, 2, 0 }, { 1, 2, 3, 0 },
                 { 1, 4, 0, 6 }, { 4, 2, 0, 6 }, { 2, 3, 0, 6 }, { 3, 1, 0, 6 } };
  REQUIRE(number_of_inverted_cells(mesh, mesh.source) == 0);
  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  Matrix3Xd image = mesh.target;
  image(2, 0) = 0.6;
  image = untangled_patch_3(mesh, linear_solver, image, VMP::internal::Budget());
  REQUIRE(number_of_inverted_cells(mesh, image) > 0);

  VMP::internal::Progress_3 progress = patient_progress();
  const VMP::internal::Splits_3 splits = find_splits_3(mesh, linear_solver, evaluated_map(mesh, image), progress);
  CHECK(std::count(splits.edges.begin(), splits.edges.end(), std::array<int, 2>{ 1, 2 }) == 1);
  CHECK(splits.edges.size() <= 3);
  image = split(mesh, splits);
  CHECK(number_of_inverted_cells(mesh, image) == 0);
  CHECK(has_target_boundary(mesh, image));
}

TEST_CASE("Flat cells become thicker, and only the vertices of flat cells move")
{
  const Numbered_mesh_3 mesh = cube_mesh(8);
  const auto [v, far] = middle_and_corner(mesh);
  const auto smallest_volume = [&](const Matrix3Xd& positions)
  {
    double result = std::numeric_limits<double>::infinity();
    for(const std::array<int, 4>& cell : mesh.cells)
      result = (std::min)(result, VMP::internal::edge_matrix(positions, cell).determinant() / 6);
    return result;
  };
  const auto moved = [&, v = v](const double t)
  {
    Matrix3Xd positions = mesh.source;
    positions.col(v) += t * Vector3d(1, 0.3, 0.2);
    return positions;
  };
  double inside_ring = 0, outside = 2; // as far as its ring allows
  for(int i = 0; i < 50; ++i)
  {
    const double t = (inside_ring + outside) / 2;
    (smallest_volume(moved(t)) > 0 ? inside_ring : outside) = t;
  }
  const Matrix3Xd start = moved(0.999 * inside_ring);
  REQUIRE(number_of_inverted_cells(mesh, start) == 0);
  REQUIRE(smallest_volume(start) < 0.01 * smallest_volume(mesh.source));

  Solver<> solver;
  VMP::internal::Linear_solver_of<Solver<> > linear_solver(solver);
  const Matrix3Xd relaxed = relaxed_flat_cells_3(mesh, linear_solver, start, VMP::internal::Budget());
  CHECK(linear_solver.number_of_iterations() > 0);
  CHECK(number_of_inverted_cells(mesh, relaxed) == 0);
  CHECK(smallest_volume(relaxed) > 10 * smallest_volume(start));
  CHECK(relaxed.col(far) == start.col(far));
  CHECK(has_target_boundary(mesh, relaxed));

  // without flat cells
  CHECK(relaxed_flat_cells_3(mesh, linear_solver, mesh.source, VMP::internal::Budget()) == mesh.source);
}

TEST_CASE("Untangling with regular cells does not depend on slivers of the source")
{
  // one problem, with slivers of the source at each vertex in turn
  Numbered_mesh_3 mesh = ring(6);
  const auto untangled = [&]()
  {
    Solver<> solver;
    fixed_boundary::Problem<VMP::Stretch_energy_3, Solver<> > problem(mesh, VMP::Stretch_energy_3(), solver);
    VMP::internal::Progress_3 progress = patient_progress();
    const VMP::internal::Newton_result_3 result = minimize_untangling_energy_3(
      problem.system, mesh.target, 0.5, progress, 0, 1e-2, VMP::internal::Reference_cells::REGULAR);
    CHECK(result.status == VMP::OK);
    return result.positions;
  };
  const Matrix3Xd positions = untangled();
  mesh.source.row(2) *= 0.01;
  CHECK((untangled() - positions).cwiseAbs().maxCoeff() == 0);
}

TEST_CASE("Untangling ends without success where there is no map")
{
  Numbered_mesh_3 mesh = cube_mesh(2); // a corner is drawn beyond the opposite one
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    if(mesh.source.col(v).norm() <= 1e-12)
      mesh.target.col(v) = Vector3d::Constant(3);
  const Outcome outcome = run(mesh);
  CHECK(outcome.status == VMP::ERROR_NOT_FLIP_FREE);
  CHECK(number_of_inverted_cells(mesh, outcome.positions) > 0);
}
