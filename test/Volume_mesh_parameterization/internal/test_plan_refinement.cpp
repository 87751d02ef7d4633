// Plans after a blocked search: the cells to refine, and whether the soft boundary continues.
#include "catch.h"
#include "cube_mesh.h"

#include <CGAL/Volume_mesh_parameterization/internal/Map/plan_refinement_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Refinement/Simplex_removal_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Soups/insert_points.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
namespace internal = CGAL::Volume_mesh_parameterization::internal;

using CGAL::Volume_mesh_parameterization::internal::Matrix3Xd;
using internal::Found_map_3;
using internal::Numbered_mesh_3;
using internal::Refinement_plan_3;
using internal::Search_start_3;
using internal::plan_refinement_3;
using internal::renumbered_start_3;
using Stage = Search_start_3::Stage;
using Edge = std::array<int, 2>;

namespace {

// Two neighbors within a face of the boundary change their places, so that there is no map.
Numbered_mesh_3 impossible_cube()
{
  Numbered_mesh_3 mesh = cube_mesh(3);
  const auto vertex_at = [&](const Eigen::Vector3d& p)
  {
    Eigen::Index v = 0;
    (mesh.source.colwise() - p).colwise().norm().minCoeff(&v);
    return v;
  };
  std::swap(mesh.target.col(vertex_at({ 1, 1, 0 })), mesh.target.col(vertex_at({ 2, 1, 0 })));
  return mesh;
}

// The boundary has not moved; the weight was raised so many times.
Found_map_3 blocked_map(const Numbered_mesh_3& mesh, const std::size_t number_of_raises)
{
  Found_map_3 found;
  found.map = evaluated_map(mesh, mesh.source);
  found.status = VMP::ERROR_BOUNDARY_NOT_REACHED;
  found.number_of_raises = number_of_raises;
  return found;
}

// The fixed boundary has left these cells inverted.
internal::Diagnosis_3 diagnosis(const std::vector<std::size_t>& inverted_cells)
{
  internal::Diagnosis_3 result;
  result.inverted_cells = inverted_cells;
  return result;
}

// The soft boundary continued from images, and was blocked at this distance.
Search_start_3 continued(const double distance)
{
  Search_start_3 start;
  start.stage = Stage::SOFT_BOUNDARY;
  start.number_of_raises = 7;
  start.distance = distance;
  return start;
}

// Rounds of splits in vain.
Search_start_3 after_vain_rounds(const std::size_t number)
{
  Search_start_3 start;
  start.number_of_vain_rounds = number;
  return start;
}

std::vector<std::size_t> sorted(std::vector<std::size_t> cells)
{
  std::sort(cells.begin(), cells.end());
  return cells;
}

} // namespace

TEST_CASE("The first soft boundary that is blocked goes on, with the cells that block it")
{
  const Numbered_mesh_3 mesh = impossible_cube();
  const Found_map_3 found = blocked_map(mesh, 4);
  REQUIRE(found.is_blocked());
  REQUIRE(found.map.distance_to_boundary == Approx(1));
  const Refinement_plan_3 plan = plan_refinement_3(mesh, found, {});
  CHECK(plan.start.stage == Stage::SOFT_BOUNDARY);
  CHECK(plan.start.positions == found.map.positions);
  CHECK(plan.start.distance == found.map.distance_to_boundary);
  CHECK(!plan.edges.empty());
  CHECK(plan.edges == edges_of_cells(mesh, sorted(blocking_cells_3(mesh, mesh.source))));
}

TEST_CASE("A soft boundary that goes on has lost its last raise, which was useless")
{
  const Numbered_mesh_3 mesh = impossible_cube();
  for(const std::size_t raises : { 5, 2, 1 })
    CHECK(plan_refinement_3(mesh, blocked_map(mesh, raises), {}).start.number_of_raises == raises - 1);
  CHECK(plan_refinement_3(mesh, blocked_map(mesh, 0), {}).start.number_of_raises == 0);
}

TEST_CASE("A soft boundary goes on if the last refinement has brought it nearer by a tenth, and else starts again")
{
  const Numbered_mesh_3 mesh = impossible_cube();
  const Found_map_3 found = blocked_map(mesh, 4);
  const double distance = found.map.distance_to_boundary;
  const auto continues = [&](const Search_start_3& before)
  {
    return plan_refinement_3(mesh, found, before).start.stage == Stage::SOFT_BOUNDARY;
  };
  CHECK(continues(continued(distance / 0.89)));
  CHECK(!continues(continued(distance / 0.91)));
  CHECK(!continues(continued(distance)));
  CHECK(!continues(continued(distance / 2)));
  // the search that starts again may be the first of a new soft boundary
  const Search_start_3 started_again = plan_refinement_3(mesh, found, continued(distance)).start;
  CHECK(started_again.number_of_raises == 0);
  CHECK(continues(started_again));
}

TEST_CASE("After three refinements in a row that bring a soft boundary no nearer, nothing is split")
{
  const Numbered_mesh_3 mesh = impossible_cube();
  const Found_map_3 found = blocked_map(mesh, 4);
  Search_start_3 before;
  for(int round = 0; round < 4; ++round) // after the first one, the search is as far as it was
  {
    const Refinement_plan_3 plan = plan_refinement_3(mesh, found, before);
    CHECK(plan.edges.empty() == (round == 3));
    before = plan.start;
  }
  before.smallest_distance = 2 * found.map.distance_to_boundary;
  CHECK_FALSE(plan_refinement_3(mesh, found, before).edges.empty());
}

TEST_CASE("Where the fixed boundary leaves fewer cells inverted than block the soft boundary, it is tried again")
{
  const Numbered_mesh_3 mesh = impossible_cube();
  Found_map_3 found = blocked_map(mesh, 4);
  const std::vector<std::size_t> blocking = sorted(blocking_cells_3(mesh, mesh.source));
  REQUIRE(blocking.size() > 2);

  std::vector<std::size_t> others; // cells that do not block
  for(std::size_t c = 0; others.size() < blocking.size(); ++c)
    if(!std::binary_search(blocking.begin(), blocking.end(), c))
      others.push_back(c);

  const auto plan = [&](const std::size_t number)
  {
    found.diagnosis = diagnosis({ others.begin(), others.begin() + number });
    return plan_refinement_3(mesh, found, {});
  };
  const Refinement_plan_3 fewer = plan(blocking.size() - 1);
  CHECK(fewer.edges == edges_of_cells(mesh, { others.begin(), others.end() - 1 }));
  CHECK(fewer.start.stage == Stage::NONE);
  found.diagnosis = diagnosis({ others[0] });
  const Refinement_plan_3 given_up = plan_refinement_3(mesh, found, after_vain_rounds(3));
  CHECK(given_up.edges == edges_of_cells(mesh, blocking));
  CHECK(given_up.start.stage == Stage::SOFT_BOUNDARY);
  CHECK(given_up.start.has_given_up_splits());
  CHECK(plan_refinement_3(mesh, found, after_vain_rounds(1)).start.number_of_vain_rounds == 0);
  for(const std::size_t number : { blocking.size(), std::size_t(0) }) // as many, or nothing known
  {
    CHECK(plan(number).edges == edges_of_cells(mesh, blocking));
    CHECK(plan(number).start.stage == Stage::SOFT_BOUNDARY);
  }
}

TEST_CASE("The cells to refine come in the order of the user")
{
  Numbered_mesh_3 mesh = impossible_cube();
  mesh.user_numbers.resize(mesh.cells.size());
  std::iota(mesh.user_numbers.rbegin(), mesh.user_numbers.rend(), std::size_t(0)); // the reverse order
  Found_map_3 found = blocked_map(mesh, 4);
  std::vector<std::size_t> blocking = sorted(blocking_cells_3(mesh, mesh.source));
  REQUIRE(blocking.size() > 1);
  std::reverse(blocking.begin(), blocking.end());
  CHECK(plan_refinement_3(mesh, found, {}).edges == edges_of_cells(mesh, blocking));

  found.diagnosis = diagnosis({ 3, 5 });
  CHECK(plan_refinement_3(mesh, found, {}).edges == edges_of_cells(mesh, { 5, 3 }));
}

TEST_CASE("A cell has six edges")
{
  Numbered_mesh_3 mesh;
  mesh.cells = { { 7, 2, 5, 3 } };
  std::set<std::set<int> > edges;
  for(const Edge& edge : edges_of_cells(mesh, { 0 }))
    edges.insert({ edge[0], edge[1] });
  CHECK(edges == std::set<std::set<int> >{ { 7, 2 }, { 7, 5 }, { 7, 3 }, { 2, 5 }, { 2, 3 }, { 5, 3 } });
}

namespace {

// A map with some inverted cells, and an edge of each to be split.
Found_map_3 stuck_map(const Numbered_mesh_3& mesh, const std::size_t number_of_inverted_cells)
{
  Found_map_3 found;
  Matrix3Xd positions = mesh.source;
  for(std::size_t c = 0; c < number_of_inverted_cells; ++c) // the cells are apart
    std::swap(positions.col(mesh.cells[c][0]), positions.col(mesh.cells[c][1]));
  found.map = evaluated_map(mesh, positions);
  REQUIRE(found.map.number_of_inverted_cells == number_of_inverted_cells);
  for(std::size_t c = 0; c < number_of_inverted_cells; ++c)
    found.splits.edges.push_back({ mesh.cells[c][0], mesh.cells[c][1] });
  found.splits.positions = positions;
  return found;
}

// Cells without common vertices, each with one prescribed vertex.
Numbered_mesh_3 three_cells()
{
  Numbered_mesh_3 mesh;
  mesh.number_of_free_vertices = 9;
  mesh.source.resize(3, 12);
  for(int c = 0; c < 3; ++c)
  {
    mesh.cells.push_back({ 3 * c, 3 * c + 1, 3 * c + 2, 9 + c });
    for(int i = 0; i < 4; ++i)
      mesh.source.col(mesh.cells[c][i]) = Eigen::Vector3d(5 * c, 0, 0)
                                        + (i == 0 ? Eigen::Vector3d::Zero() : Eigen::Vector3d(Eigen::Vector3d::Unit(i - 1)));
  }
  mesh.target = mesh.source;
  return mesh;
}

} // namespace

TEST_CASE("Untangling that was stuck goes on while splits make inverted cells fewer")
{
  const Numbered_mesh_3 mesh = three_cells();
  Search_start_3 start;
  for(const std::size_t number : { 3, 2, 1 })
  {
    const Found_map_3 found = stuck_map(mesh, number);
    const Refinement_plan_3 plan = plan_refinement_3(mesh, found, start);
    start = plan.start;
    CHECK(start.stage == Stage::UNTANGLING);
    CHECK(start.positions == found.map.positions);
    CHECK(start.number_of_vain_rounds == 0);
    CHECK(start.fewest_inverted_cells == number);
    CHECK(plan.edges.size() == number);
  }
}

TEST_CASE("After three rounds of splits in vain, untangling is given up")
{
  const Numbered_mesh_3 mesh = three_cells();
  const Found_map_3 found = stuck_map(mesh, 2);
  Search_start_3 start;
  start.may_split = true;
  for(const std::size_t vain_rounds : { 0, 1, 2, 3 })
  {
    CHECK(start.may_split_inverted_cells());
    const Refinement_plan_3 plan = plan_refinement_3(mesh, found, start);
    start = plan.start;
    start.may_split = true;
    CHECK(start.stage == (vain_rounds < 3 ? Stage::UNTANGLING : Stage::NONE));
    CHECK(start.number_of_vain_rounds == vain_rounds);
    CHECK(plan.edges.size() == (vain_rounds < 3 ? 2 : 0));
  }
  CHECK(!start.may_split_inverted_cells()); // cells are left to the soft boundary
  start = after_vain_rounds(0);
  CHECK(!start.may_split_inverted_cells());
}

namespace {

// Four cells around the edge of two points, with a ring of four around it.
struct Four_cells
{
  Matrix3Xd source;
  internal::Body_3 body;

  Four_cells() : source(3, 6)
  {
    source << 1, 1, 0, 1, 2, 1,
              0, 0, 0, -1, 0, 1,
             -1, 1, 0, 0, 0, 0;
    VMP::Tetrahedron_soup_3 soup;
    for(int v = 0; v < 6; ++v)
      soup.points.push_back({ source(0, v), source(1, v), source(2, v) });
    for(std::size_t i = 0; i < 4; ++i)
      soup.cells.push_back({ 0, 1, 2 + i, 2 + (i + 1) % 4 });
    soup.cell_references.resize(4);
    body = internal::body_of(soup);
  }

  internal::Numbered_body_3 numbered() const
  {
    return internal::Numbered_body_3(body, internal::used_points(body.boundary, body.points.size()), body.points);
  }

  // The images of the vertices in the order of the numbered mesh, from those of the points.
  Matrix3Xd image(const internal::Numbered_body_3& numbers, const Matrix3Xd& positions) const
  {
    Matrix3Xd result(3, positions.cols());
    for(Eigen::Index v = 0; v < positions.cols(); ++v)
      result.col(numbers.vertices[v]) = positions.col(v);
    return result;
  }

  std::vector<internal::Insertion_3> split() { return internal::split_edges_3(body, { { 0, 1 } }); }
};

} // namespace

namespace {

Search_start_3 start_from(const Stage stage, const Matrix3Xd& image)
{
  Search_start_3 start;
  start.stage = stage;
  start.positions = image;
  start.number_of_raises = 3;
  start.distance = 0.5;
  return start;
}

} // namespace

TEST_CASE("A search that continues has the images of all vertices, with midpoints for new ones")
{
  const Stage stage = GENERATE(Stage::UNTANGLING, Stage::SOFT_BOUNDARY);
  const double factor = stage == Stage::UNTANGLING ? -1 : 2; // untangling continues, although cells are inverted
  Four_cells cells;
  const auto before = cells.numbered();
  const Matrix3Xd image = factor * cells.image(before, cells.source);
  const auto inserted = cells.split();
  REQUIRE(inserted.size() == 1);

  const auto after = cells.numbered();
  REQUIRE(after.points.size() == 7);
  const Search_start_3 start = renumbered_start_3({ {}, {}, start_from(stage, image) }, before.points, inserted, after);
  CHECK(start.stage == stage);
  CHECK(start.number_of_raises == 3);
  CHECK(start.distance == 0.5);
  REQUIRE(start.positions.cols() == 7);
  CHECK(start.positions.col(after.vertices[inserted[0].point]) == Eigen::Vector3d(factor, 0, 0));
  for(int v = 0; v < 6; ++v)
    CHECK(start.positions.col(after.vertices[v]) == factor * cells.source.col(v));
}

TEST_CASE("Where splits come with images of the new vertices, a search that continues has these")
{
  Four_cells cells;
  const auto before = cells.numbered();
  Found_map_3 found;
  found.map = evaluated_map(before.mesh, before.mesh.source);
  const Eigen::Vector3d new_image(2.5, 0, 0.25);
  found.splits = { { { before.vertices[0], before.vertices[1] } }, { new_image }, 2 * before.mesh.source };
  const Refinement_plan_3 plan = plan_refinement_3(before.mesh, found, {});
  CHECK(plan.edges == found.splits.edges);
  const auto inserted = cells.split();
  REQUIRE(inserted.size() == 1);

  const auto after = cells.numbered();
  const Search_start_3 start = renumbered_start_3(plan, before.points, inserted, after);
  CHECK(start.stage == Stage::UNTANGLING);
  REQUIRE(start.positions.cols() == 7);
  CHECK(start.positions.col(after.vertices[inserted[0].point]) == new_image);
  for(int v = 0; v < 6; ++v)
    CHECK(start.positions.col(after.vertices[v]) == 2 * cells.source.col(v));
}

TEST_CASE("Images that rounding has spoilt are given up")
{
  Four_cells cells;
  const auto before = cells.numbered();
  // the midpoint of the edge is rounded to a vertex of the ring
  Matrix3Xd positions = cells.source;
  positions(0, 1) = std::nextafter(1., 2.);
  positions(0, 2) = 1;
  const Matrix3Xd image = cells.image(before, positions);
  REQUIRE(internal::inverted_cells(before.mesh, image).number == 0);

  const auto inserted = cells.split();
  REQUIRE(inserted.size() == 1);
  const Search_start_3 start
    = renumbered_start_3({ {}, {}, start_from(Stage::SOFT_BOUNDARY, image) }, before.points, inserted, cells.numbered());
  CHECK(start.stage == Stage::NONE); // so that the next soft boundary that is blocked counts as the first one
  CHECK(start.number_of_raises == 0);
}

TEST_CASE("Given edges are split, longest first, and others are ignored")
{
  const Numbered_mesh_3 mesh = cube_mesh(2);
  internal::Body_3 body = internal::body_of(source_soup(mesh));
  const auto at = [&](const double x, const double y, const double z)
  {
    std::size_t v = 0;
    while(mesh.source.col(v) != Eigen::Vector3d(x, y, z))
      ++v;
    return v;
  };
  const std::size_t center = at(1, 1, 1), corner = at(0, 0, 0);
  const auto inserted = internal::split_edges_3(body, {
    { at(1, 1, 0), center }, { at(1, 0, 0), center },
    { corner, center }, { center, corner },
    { corner, at(1, 0, 0) },                      // an edge of the boundary
    { corner, at(2, 2, 2) }, { corner, corner } }); // no edges
  REQUIRE(inserted.size() == 3);
  const std::vector<internal::Simplex_3> expected
    = { { corner, center }, { at(1, 0, 0), center }, { at(1, 1, 0), center } };
  for(std::size_t i = 0; i < 3; ++i)
  {
    CHECK(inserted[i].simplex == expected[i]);
    CHECK(inserted[i].point == mesh.source.cols() + i);
    CHECK(internal::to_vector(body.points[inserted[i].point])
          == (mesh.source.col(expected[i][0]) + mesh.source.col(expected[i][1])) / 2);
  }
  CHECK(body.cells.size() == 48 + 6 + 4 + 6);
}

TEST_CASE("Edges that must go are split longest first, and facets and cells then need no vertex")
{
  const Numbered_mesh_3 mesh = cube_mesh(2);
  const auto number_of_points = static_cast<std::size_t>(mesh.source.cols());
  internal::Body_3 body = internal::body_of(source_soup(mesh));
  const auto is_old = [&](const internal::Simplex_3& simplex)
  { return std::all_of(simplex.begin(), simplex.end(), [&](const std::size_t v) { return v < number_of_points; }); };
  const std::vector<internal::Insertion_3> inserted
    = internal::Simplex_removal_3(body, is_old).run(std::vector<bool>(number_of_points, true), internal::Budget());
  REQUIRE(inserted.size() > 1);
  std::vector<double> lengths;
  for(const internal::Insertion_3& insertion : inserted)
  {
    REQUIRE(insertion.simplex.size() == 2);
    lengths.push_back((mesh.source.col(insertion.simplex[0]) - mesh.source.col(insertion.simplex[1])).norm());
  }
  CHECK(std::is_sorted(lengths.rbegin(), lengths.rend()));
}

TEST_CASE("Once edges at the boundary are split, only new vertices inside are joined to those there")
{
  const Numbered_mesh_3 mesh = cube_mesh(3);
  internal::Body_3 body = internal::body_of(source_soup(mesh));
  const std::vector<bool> was_outer = internal::used_points(body.boundary, body.points.size());
  internal::split_edges_at_boundary_3(body);
  const std::vector<bool> is_outer = internal::used_points(body.boundary, body.points.size());
  CHECK(std::count(is_outer.begin(), is_outer.end(), true) == std::count(was_outer.begin(), was_outer.end(), true));
  CHECK(internal::body_of(body.points, body.cells).boundary.size() == 6 * 3 * 3 * 2); // no edge of the boundary is split
  double volume = 0;
  for(const std::array<std::size_t, 4>& cell : body.cells)
  {
    const auto edge = [&](const std::size_t i) -> Eigen::Vector3d
    { return internal::to_vector(body.points[cell[i]]) - internal::to_vector(body.points[cell[0]]); };
    const double of_cell = edge(1).cross(edge(2)).dot(edge(3)) / 6;
    CHECK(of_cell > 0);
    volume += of_cell;
    if(std::any_of(cell.begin(), cell.end(), [&](const std::size_t v) { return is_outer[v]; }))
      for(const std::size_t v : cell)
        CHECK((is_outer[v] || v >= static_cast<std::size_t>(mesh.source.cols())));
  }
  CHECK(std::abs(volume - 27) < 1e-9);
}

TEST_CASE("Cells, facets and edges keep references and data where they are split, and point data are interpolated")
{
  const Numbered_mesh_3 mesh = cube_mesh(2);
  VMP::Tetrahedron_soup_3 soup = source_soup(mesh);
  const auto vertex = [&](const double x, const double y, const double z)
  {
    const auto found = std::find(soup.points.begin(), soup.points.end(), std::array<double, 3>{ x, y, z });
    REQUIRE(found != soup.points.end());
    return static_cast<std::size_t>(found - soup.points.begin());
  };
  const std::size_t center = vertex(1, 1, 1), corner = vertex(2, 2, 2), below = vertex(1, 1, 0), other = vertex(0, 0, 0);
  soup.edges = { { center, corner }, { other, center } };
  soup.edge_references = { 3, 4 };
  soup.point_data = { { "position", 3, false, {} }, { "index", 1, true, {} } };
  soup.cell_data = { { "index", 1, true, {} } };
  for(std::size_t v = 0; v < soup.points.size(); ++v)
  {
    soup.point_data[0].values.insert(soup.point_data[0].values.end(), soup.points[v].begin(), soup.points[v].end());
    soup.point_data[1].values.push_back(static_cast<double>(v));
  }
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
  {
    soup.cell_references[c] = static_cast<int>(c);
    soup.cell_data[0].values.push_back(static_cast<double>(c));
  }
  soup.edge_data = { { "pair", 2, false, { 1, 2, 3, 4 } } };
  const std::size_t number_of_cells = soup.cells.size();
  internal::Body_3 body = internal::body_of(soup);
  const std::vector<internal::Insertion_3> inserted = internal::split_edges_3(body, { { center, corner }, { center, below } });
  REQUIRE(inserted.size() == 2);
  VMP::Tetrahedron_soup_3 refined = soup;
  internal::insert_points(body, inserted, refined);
  CHECK(refined.edges == body.edges);
  CHECK(refined.edges.size() == 3);
  CHECK(refined.edge_references == std::vector<int>{ 3, 4, 3 });
  CHECK(refined.edge_data[0].values == std::vector<double>{ 1, 2, 3, 4, 1, 2 });
  REQUIRE(refined.cells.size() > number_of_cells);
  for(std::size_t c = 0; c < refined.cells.size(); ++c)
    CHECK(refined.cell_data[0].values.at(c) == refined.cell_references[c]);
  for(std::size_t v = 27; v < 29; ++v)
  {
    for(std::size_t i = 0; i < 3; ++i)
      CHECK(refined.point_data[0].values.at(3 * v + i) == refined.points[v][i]);
    CHECK(refined.point_data[1].values.at(v) == static_cast<double>(center)); // integers are not interpolated
  }
  refined.point_data[0].values.pop_back();
  CHECK_THROWS_AS(internal::body_of(refined), VMP::Input_error);
}

TEST_CASE("Cells and marked facets of a soup keep their references where they are split, and the body its volume")
{
  const Numbered_mesh_3 mesh = cube_mesh(2);
  VMP::Tetrahedron_soup_3 soup = source_soup(mesh);
  std::map<int, double> volumes, areas;
  const auto measure = [&](const VMP::Tetrahedron_soup_3& s, std::map<int, double>& volume, std::map<int, double>& area)
  {
    const auto p = [&](const std::size_t v) { return internal::to_vector(s.points[v]); };
    for(std::size_t c = 0; c < s.cells.size(); ++c)
    {
      const auto& [i, j, k, l] = s.cells[c];
      const double six_volumes = (p(j) - p(i)).cross(p(k) - p(i)).dot(p(l) - p(i));
      CHECK(six_volumes > 0);
      volume[s.cell_references[c]] += six_volumes;
    }
    for(std::size_t f = 0; f < s.facets.size(); ++f)
    {
      const auto& [i, j, k] = s.facets[f];
      area[s.facet_references[f]] += (p(j) - p(i)).cross(p(k) - p(i)).norm();
    }
  };
  soup.facets.clear();
  soup.facet_references.clear();
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
  {
    const auto& cell = soup.cells[c];
    double x = 0;
    for(const std::size_t v : cell)
      x += mesh.source(0, v) / 4;
    soup.cell_references[c] = x < 1 ? 5 : 7;
    for(std::size_t i = 0; i < 4; ++i) // the plane between both parts, from one side
      if(x < 1 && mesh.source(0, cell[(i + 1) % 4]) == 1 && mesh.source(0, cell[(i + 2) % 4]) == 1
         && mesh.source(0, cell[(i + 3) % 4]) == 1)
      {
        soup.facets.push_back({ cell[(i + 1) % 4], cell[(i + 2) % 4], cell[(i + 3) % 4] });
        soup.facet_references.push_back(9);
      }
  }
  measure(soup, volumes, areas);
  REQUIRE(volumes == std::map<int, double>{ { 5, 24. }, { 7, 24. } });
  REQUIRE(areas == std::map<int, double>{ { 9, 8. } });

  internal::Body_3 body = internal::body_of(soup);
  const auto is_old = [](const internal::Simplex_3& s) { return *std::max_element(s.begin(), s.end()) < 27; };
  const std::vector<internal::Insertion_3> inserted
    = internal::Simplex_removal_3(body, is_old).run(std::vector<bool>(27, true), internal::Budget());
  REQUIRE(inserted.size() > 8);
  VMP::Tetrahedron_soup_3 refined = soup;
  internal::insert_points(body, inserted, refined);
  std::map<int, double> refined_volumes, refined_areas;
  measure(refined, refined_volumes, refined_areas);
  for(const int reference : { 5, 7 })
    CHECK(refined_volumes.at(reference) == Approx(24));
  CHECK(refined_areas.at(9) == Approx(8));
  CHECK(refined.facets.size() > soup.facets.size());
  CHECK(internal::body_of(refined).boundary.size() == body.boundary.size()); // which throws if cells overlap
}
