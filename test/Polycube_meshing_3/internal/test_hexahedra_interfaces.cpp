// Hexahedra that follow the interfaces between subdomains.
#include "catch.h"
#include "array_of_vtu_file.h"
#include "hexahedra_of_bodies.h"

#include <CGAL/Polycube_meshing_3/IO/write_hexahedron_soup.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/Improvement/Best_hexahedra_3.h>
#include <CGAL/Polycube_meshing_3/internal/Hexahedra/found_hexahedra_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

// A box of several subdomains, which is its own domain: the cube [0, n]^3, whose points move by f.
template <typename Function, typename Subdomain>
Body box_of_subdomains(const int n, const Function& f, const Subdomain& subdomain)
{
  Body body(n, 0, same);
  for(std::size_t c = 0; c < body.soup.cells.size(); ++c)
    body.soup.cell_references[c] = subdomain(body.center_of_image(body.soup.cells[c]));
  for(std::array<double, 3>& p : body.images)
  {
    const Vector3d q = f(vector(p));
    p = { q[0], q[1], q[2] };
  }
  body.soup.points = body.images;
  return body;
}

// Two half spaces: the interface is the plane z = 2 + 0.3 (x - 2).
Body slanted_box()
{
  return box_of_subdomains(4, [](const Vector3d& p) -> Vector3d
                           { return { p[0], p[1], p[2] + 0.3 * (p[0] - 2) * (1 - std::abs(p[2] - 2) / 2) }; },
                           [](const Vector3d& p) { return p[2] < 2 ? 1 : 2; });
}

// A ball of radius 3 in the middle of a cube of width 8.
Body ball_in_box()
{
  const Vector3d middle = Vector3d::Constant(4);
  return box_of_subdomains(8, [=](const Vector3d& p) -> Vector3d
  {
    const Vector3d q = p - middle;
    const double size = q.lpNorm<Eigen::Infinity>(), t = (std::max)(0., size - 3);
    return q.isZero() ? p : Vector3d(middle + q * ((1 - t) * size / q.norm() + t));
  },
  [=](const Vector3d& p) { return (p - middle).lpNorm<Eigen::Infinity>() < 3 ? 5 : 3; });
}

// Layers whose interfaces are between planes of a grid of width 1: z = 1.3 and z = 2.8.
Body layered_box()
{
  return box_of_subdomains(4, [](const Vector3d& p) -> Vector3d
                           { return { p[0], p[1], p[2] == 1 ? 1.3 : p[2] == 3 ? 2.8 : p[2] }; },
                           [](const Vector3d& p) { return p[2] < 1 ? 1 : p[2] < 3 ? 2 : 3; });
}

// Adds a box to these layers, with a width of 2.2 in a corner, through the first interface.
Body box_in_corner_of_layers()
{
  return box_of_subdomains(4, [](const Vector3d& p) -> Vector3d
  {
    return { p[0] == 2 ? 2.2 : p[0], p[1] == 2 ? 2.2 : p[1], p[2] == 1 ? 1.3 : p[2] == 2 ? 2.2 : p[2] };
  },
  [](const Vector3d& p) { return (p.array() < 2).all() ? 9 : p[2] < 1 ? 1 : 2; });
}

// Volumes of subdomains, by tetrahedra around the centers of cells: exact where quadrangles of interfaces are plane.
std::map<int, double> volumes_by_centers(const Hexahedron_soup_3& mesh)
{
  std::map<int, double> result;
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
  {
    Vector3d center = Vector3d::Zero();
    for(const std::size_t v : mesh.cells[c])
      center += vector(mesh.points[v]) / 8;
    for(const auto& q : PM::internal::quadrangles_of_hexahedron)
      for(const std::size_t i : { 1, 2 })
      {
        Eigen::Matrix3d edges;
        edges << vector(mesh.points[mesh.cells[c][q[0]]]) - center, vector(mesh.points[mesh.cells[c][q[i]]]) - center,
                 vector(mesh.points[mesh.cells[c][q[i + 1]]]) - center;
        result[mesh.cell_references[c]] += edges.determinant() / 6;
      }
  }
  return result;
}

// Checks that each quadrangle is on the boundary, between two hexahedra of one subdomain, or one of an interface.
void check_conformity(const Hexahedron_soup_3& mesh)
{
  std::map<std::set<std::size_t>, std::vector<std::size_t> > cells;
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
    for(const auto& q : PM::internal::quadrangles_of_hexahedron)
      cells[{ mesh.cells[c][q[0]], mesh.cells[c][q[1]], mesh.cells[c][q[2]], mesh.cells[c][q[3]] }].push_back(c);
  std::set<std::set<std::size_t> > boundary, interfaces;
  for(const auto& [quadrangle, of_quadrangle] : cells)
  {
    REQUIRE(of_quadrangle.size() <= 2);
    if(of_quadrangle.size() == 1)
      boundary.insert(quadrangle);
    else if(mesh.cell_references[of_quadrangle[0]] != mesh.cell_references[of_quadrangle[1]])
      interfaces.insert(quadrangle);
  }
  const auto sets = [](const std::vector<std::array<std::size_t, 4> >& quadrangles)
  {
    std::set<std::set<std::size_t> > result;
    for(const auto& q : quadrangles)
      CHECK(result.emplace(q.begin(), q.end()).second);
    return result;
  };
  CHECK(sets(mesh.facets) == boundary);
  CHECK(sets(mesh.interface_facets) == interfaces);
  REQUIRE(mesh.interface_cells.size() == mesh.interface_facets.size());
  for(std::size_t i = 0; i < mesh.interface_facets.size(); ++i)
  {
    const auto& [c, d] = mesh.interface_cells[i];
    CHECK(mesh.cell_references[c] < mesh.cell_references[d]);
    for(const std::size_t v : mesh.interface_facets[i])
      for(const std::size_t cell : { c, d })
        CHECK(std::count(mesh.cells[cell].begin(), mesh.cells[cell].end(), v) == 1);
  }
}

// Returns the largest distance of the vertices of quadrangles between subdomains from a surface.
template <typename Distance>
double distance_of_interface(const Hexahedron_soup_3& mesh, const Distance& distance)
{
  double result = 0;
  for(const auto& q : mesh.interface_facets)
    for(const std::size_t v : q)
      result = (std::max)(result, std::abs(distance(vector(mesh.points[v]))));
  return result;
}

} // namespace

TEST_CASE("Hexahedra on both sides of a slanted plane share quadrangles in it, with a layer on both sides")
{
  const Body body = slanted_box();
  Hexahedron_soup_3 mesh, staircases;
  const Hexahedral_mesh_result result = PM::make_hexahedral_mesh_3(body.soup, body.images, 0.5, mesh);
  REQUIRE(result.status == VMP::OK);
  CHECK(result.message == VMP::get_error_message(VMP::OK));
  CHECK(result.minimum_scaled_jacobian > 0.4);
  CHECK(smallest_determinant(mesh) > 0);
  check_conformity(mesh);
  check_boundary(mesh, body);
  CHECK(enclosed_volume(mesh) == Approx(64));
  const auto distance = [](const Vector3d& p) { return p[2] - 2 - 0.3 * (p[0] - 2); };
  CHECK(distance_of_interface(mesh, distance) < 1e-12);
  CHECK(result.interface_distance < 1e-12);
  CHECK(mesh.cells.size() == 512 + 2 * mesh.interface_facets.size());
  for(const auto& [reference, volume] : volumes_by_centers(mesh))
    CHECK(volume == Approx(32));
  REQUIRE(result.volumes.size() == 2);
  for(const PM::Subdomain_volumes& volumes : result.volumes)
  {
    CHECK(volumes.of_tetrahedra == Approx(32));
    CHECK(volumes.of_hexahedra == Approx(32));
  }
  for(const std::array<std::size_t, 2>& cells : mesh.interface_cells)
    for(const std::size_t k : { 0, 1 }) // the hexahedron of subdomain 1 is below, that of 2 above
      for(const std::size_t v : mesh.cells[cells[k]])
        CHECK((k == 0 ? 1 : -1) * distance(vector(mesh.points[v])) < 1e-12);

  const Hexahedral_mesh_result with_staircases
    = PM::make_hexahedral_mesh_3(body.soup, body.images, 0.5, staircases, CGAL::parameters::do_keep_interfaces(false));
  REQUIRE(with_staircases.status == VMP::OK);
  CHECK(with_staircases.minimum_scaled_jacobian == Approx(1));
  CHECK(staircases.cells.size() == 512);
  CHECK(with_staircases.interface_distance > 0.1);
  check_conformity(staircases);
}

TEST_CASE("A ball in a box keeps its surface and its volume")
{
  const Body body = ball_in_box();
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = PM::make_hexahedral_mesh_3(body.soup, body.images, 1, mesh);
  REQUIRE(result.status == VMP::OK);
  CHECK(result.minimum_scaled_jacobian > 0.15);
  CHECK(smallest_determinant(mesh) > 0);
  check_conformity(mesh);
  CHECK(distance_of_interface(mesh, [](const Vector3d& p) { return (p - Vector3d::Constant(4)).norm() - 3; }) < 0.15);
  REQUIRE(result.volumes.size() == 2);
  CHECK(result.volumes[1].reference == 5);
  CHECK(result.volumes[1].of_hexahedra == Approx(result.volumes[1].of_tetrahedra).epsilon(1e-4));
  CHECK(volumes_by_centers(mesh).at(5) == Approx(result.volumes[1].of_hexahedra).epsilon(0.01));
  CHECK(result.volumes[0].of_hexahedra + result.volumes[1].of_hexahedra == Approx(512));
}

TEST_CASE("Layers keep their plane interfaces without more hexahedra, also beside a box in their corner")
{
  for(const Body& body : { layered_box(), box_in_corner_of_layers() })
  {
    Hexahedron_soup_3 mesh;
    const Hexahedral_mesh_result result = PM::make_hexahedral_mesh_3(body.soup, body.images, 1, mesh);
    REQUIRE(result.status == VMP::OK);
    CHECK(result.message == VMP::get_error_message(VMP::OK));
    CHECK(mesh.cells.size() == 64);
    CHECK(result.minimum_scaled_jacobian > 0.8);
    CHECK(smallest_determinant(mesh) > 0);
    check_conformity(mesh);
    REQUIRE(result.volumes.size() == 3);
    const std::map<int, double> volumes = volumes_by_centers(mesh);
    for(const PM::Subdomain_volumes& of_subdomain : result.volumes)
    {
      CHECK(of_subdomain.of_hexahedra == Approx(of_subdomain.of_tetrahedra));
      CHECK(volumes.at(of_subdomain.reference) == Approx(of_subdomain.of_tetrahedra));
    }
    CHECK(result.interface_distance < 1e-12);
  }
}

TEST_CASE("A turned box in a box keeps its edges and corners, with a layer around each of its sides")
{
  const Vector3d middle = Vector3d::Constant(4);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.5, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Body body = box_of_subdomains(8, [&](const Vector3d& p) -> Vector3d // turned in the middle, not on the boundary
  {
    const Vector3d q = p - middle;
    const double t = (std::min)(1., 2 - q.lpNorm<Eigen::Infinity>() / 2);
    return middle + t * (turn * q) + (1 - t) * q;
  },
  [&](const Vector3d& p) { return (p - middle).lpNorm<Eigen::Infinity>() < 2 ? 2 : 1; });
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = PM::make_hexahedral_mesh_3(body.soup, body.images, 1, mesh);
  REQUIRE(result.status == VMP::OK);
  CHECK(result.message == VMP::get_error_message(VMP::OK));
  CHECK(result.minimum_scaled_jacobian > 0.2); // without layers around sides, two edges of a quadrangle are in one line
  CHECK(smallest_determinant(mesh) > 0);
  check_conformity(mesh);
  check_boundary(mesh, body);
  const auto distance = [&](const Vector3d& p) { return (turn.transpose() * (p - middle)).lpNorm<Eigen::Infinity>() - 2; };
  CHECK(distance_of_interface(mesh, distance) < 1e-12);
  CHECK(result.interface_distance < 1e-12);
  CHECK(volumes_by_centers(mesh).at(2) == Approx(64));
  for(int k = 0; k < 8; ++k)
  {
    const Vector3d corner = middle + turn * Vector3d(k % 2 ? 2 : -2, k / 2 % 2 ? 2 : -2, k / 4 ? 2 : -2);
    CHECK(std::any_of(mesh.points.begin(), mesh.points.end(), [&](const std::array<double, 3>& p)
                      { return (vector(p) - corner).norm() < 1e-12; }));
  }
}

TEST_CASE("Staircases do not replace valid hexahedra if a subdomain loses much of its volume")
{
  PM::internal::Best_hexahedra_3 fitted;
  fitted.mesh.cells.emplace_back();
  fitted.result.has_valid_mesh = true;
  fitted.result.minimum_scaled_jacobian = GENERATE(0.01, 0.2); // bad, and poor
  fitted.result.mean_scaled_jacobian = 0.7;
  fitted.result.interface_distance = 0.6;
  fitted.result.volumes = {{1, 1, 0.97}, {2, 4, 4.03}};
  Hexahedral_mesh_result staircases = fitted.result;
  staircases.minimum_scaled_jacobian = staircases.mean_scaled_jacobian = 1;
  CHECK(is_better_as_staircases(staircases, fitted));
  staircases.volumes = {{1, 1, 0.8}, {2, 4, 4.2}};
  CHECK(!is_better_as_staircases(staircases, fitted));
  fitted.result.has_valid_mesh = false;
  fitted.result.number_of_inverted_corners = 1;
  CHECK(is_better_as_staircases(staircases, fitted));
}

TEST_CASE("Hexahedra that deviate from subdomains, interfaces or the boundary are incomplete unless staircases are asked for")
{
  using namespace PM::internal;
  const Body body = layered_box();
  const Mapped_soup_3 soup(body.soup, body.images);
  const Body_with_domain_3 with_domain(soup, false);
  const auto status = [&](const double volume, const double distance, const Staircases staircases)
  {
    Hexahedral_mesh_result result;
    result.message = "Success. More.";
    result.volumes = {{1, 20, 40 - volume}, {2, 20, volume}};
    check_completeness(with_domain, { distance, { 1, 2, 3 } }, 0.5, 1, staircases, result);
    CHECK((result.status == VMP::OK) == (result.message == "Success. More."));
    CHECK((result.status == VMP::OK || result.message.find("Success") == std::string::npos));
    return result.status;
  };
  CHECK(status(19.7, 0.24, Staircases::NONE) == VMP::OK);
  CHECK(status(19.5, 0.24, Staircases::NONE) == VMP::ERROR_INCOMPLETE_HEXAHEDRA);
  CHECK(status(20.5, 0.24, Staircases::BETTER) == VMP::ERROR_INCOMPLETE_HEXAHEDRA);
  CHECK(status(19.5, 0.24, Staircases::ASKED) == VMP::OK);
  CHECK(status(0, 0.24, Staircases::ASKED) == VMP::ERROR_INCOMPLETE_HEXAHEDRA);
  CHECK(status(20, 0.26, Staircases::ASKED) == VMP::ERROR_INCOMPLETE_HEXAHEDRA);
}

TEST_CASE("Vertices of the boundary stay on it where an interface between hexahedra ends there and that of the body does not")
{
  for(const double bottom : { 1, 0 }) // of a box that is 0.2 below the boundary; its sides end on the boundary below, or nowhere
  {
    const Body body = box_of_subdomains(4, [](const Vector3d& p) -> Vector3d
                                        { return { p[0] == 2 ? 2.3 : p[0], p[1], p[2] == 3 ? 3.8 : p[2] }; },
                                        [=](const Vector3d& p) { return (p.head<2>().array() - 1.5).abs().maxCoeff() < 0.5
                                                                        && bottom < p[2] && p[2] < 3 ? 2 : 1; });
    Hexahedron_soup_3 mesh;
    const Hexahedral_mesh_result result = PM::make_hexahedral_mesh_3(body.soup, body.images, 1, mesh);
    REQUIRE(result.has_valid_mesh);
    CHECK(result.status == VMP::ERROR_INCOMPLETE_HEXAHEDRA); // the box is higher than that of the body, by more than 2 %
    CHECK(result.minimum_scaled_jacobian > 0.7);
    CHECK(std::any_of(mesh.interface_facets.begin(), mesh.interface_facets.end(), [&](const auto& q)
                      { return std::any_of(q.begin(), q.end(), [&](const std::size_t v) { return mesh.points[v][2] == 4; }); }));
    check_boundary(mesh, body);
    CHECK(enclosed_volume(mesh) == Approx(64));
    CHECK(result.message.find("staircases") == std::string::npos);
  }
}

TEST_CASE("Vertices where an interface crosses edges of the body do not move to corners far away")
{
  const Body body = box_of_subdomains(4, same, [](const Vector3d& p) { return p[0] < 2 ? 1 : 2; });
  const PM::internal::Mapped_soup_3 soup(body.soup, body.images);
  const PM::internal::Body_surface_3 surface(soup);
  PM::internal::Body_interfaces_3 interfaces(soup, surface);
  Hexahedron_soup_3 hexahedra;
  REQUIRE(PM::make_hexahedral_mesh_3(body.soup, body.images, 1, hexahedra).status == VMP::OK);
  Hexahedra_3 mesh;
  for(const auto& p : hexahedra.points)
    mesh.points.push_back(vector(p));
  mesh.cells = hexahedra.cells;
  mesh.cell_references = hexahedra.cell_references;
  mesh.facets = hexahedra.facets;
  mesh.facet_cells = hexahedra.facet_cells;
  const auto vertex_at = [&](const VMP::internal::Vector_3& p) -> VMP::internal::Vector_3&
  {
    return *std::min_element(mesh.points.begin(), mesh.points.end(), [&](const auto& q, const auto& r)
                             { return (q - p).norm() < (r - p).norm(); });
  };
  VMP::internal::Vector_3& second = vertex_at({ 2, 1, 0 }); // on the edge of another vertex, while the corner opposite has none
  vertex_at({ 2, 4, 4 })[1] = 3.3;
  second = { 2.2, 0, 0 };
  std::vector<PM::internal::Interface_quadrangle_3> quadrangles = PM::internal::interface_quadrangles_3(mesh);
  PM::internal::set_patches(mesh, interfaces, quadrangles);
  const auto positions = PM::internal::Search_for_positions_3(mesh, quadrangles, interfaces).run();
  CHECK((positions[&second - mesh.points.data()].point - second).norm() < 1);
}

TEST_CASE("Vertices where an interface ends in a wedge on the boundary slide along its edge")
{
  // The edge y = 2, z = 4 of the wedge 2 y - 4 < z - 4 < y - 2 is on the boundary, and both of its sides are interfaces.
  const Body body = box_of_subdomains(4, same, [](const Vector3d& p) { return p[1] < 2 && p[2] < p[1] + 2 ? 2 : 1; });
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = PM::make_hexahedral_mesh_3(body.soup, body.images, 0.6, mesh);
  REQUIRE(result.status == VMP::OK);
  check_boundary(mesh, body);
  CHECK(result.minimum_scaled_jacobian > 0.4);
}

TEST_CASE("Files of hexahedra have the quadrangles of interfaces, with both subdomains")
{
  Body body = layered_box();
  Hexahedron_soup_3 mesh;
  for(const auto& cell : body.soup.cells)
    for(std::size_t i = 0; i < 4; ++i)
    {
      const std::array<std::size_t, 3> facet = { cell[(i + 1) % 4], cell[(i + 2) % 4], cell[(i + 3) % 4] };
      if(std::all_of(facet.begin(), facet.end(), [&](const std::size_t v) { return body.images[v][2] == 1.3; }))
      {
        body.soup.facets.push_back(facet);
        body.soup.facet_references.push_back(7);
      }
    }
  REQUIRE(PM::make_hexahedral_mesh_3(body.soup, body.images, 1, mesh).status == VMP::OK);
  REQUIRE(mesh.interface_facets.size() == 32);
  CHECK(std::count(mesh.interface_references.begin(), mesh.interface_references.end(), 7) == 16);
  std::ostringstream vtu, inp, medit;
  PM::IO::write_VTU(vtu, mesh);
  const auto pairs = array_of<std::int32_t>(vtu.str(), "interface", "Int32");
  REQUIRE(pairs.size() == 2 * (64 + 96 + 32));
  for(std::size_t i = 0; i < 32; ++i)
  {
    const bool is_lower = vector(mesh.points[mesh.interface_facets[i][0]])[2] < 2;
    CHECK(pairs[2 * (160 + i)] == (is_lower ? 1 : 2));
    CHECK(pairs[2 * (160 + i) + 1] == (is_lower ? 2 : 3));
  }
  PM::IO::write_INP(inp, mesh);
  for(const std::string name : { "INTERFACE_1_2", "INTERFACE_2_1", "INTERFACE_2_3", "INTERFACE_3_2", "SURFACE_7" })
  {
    const std::size_t begin = inp.str().find("*SURFACE, TYPE=ELEMENT, NAME=" + name + "\n");
    REQUIRE(begin != std::string::npos);
    const std::string section = inp.str().substr(begin + 1, inp.str().find('*', begin + 1) - begin - 1);
    CHECK(std::count(section.begin(), section.end(), '\n') == 16 + 1);
    const bool is_above = name == "INTERFACE_2_3" || name == "INTERFACE_1_2" || name == "SURFACE_7";
    CHECK(section.find(is_above ? ", S2\n" : ", S1\n") != std::string::npos);
  }
  PM::IO::write_MEDIT(medit, mesh);
  CHECK(medit.str().find("\nQuadrilaterals\n128\n") != std::string::npos);
  const std::string quadrangles = medit.str().substr(medit.str().find("Quadrilaterals"));
  const auto number_of_lines = [&](const std::string& end)
  {
    int result = 0;
    for(std::size_t i = quadrangles.find(end); i != std::string::npos; i = quadrangles.find(end, i + 1))
      ++result;
    return result;
  };
  CHECK(number_of_lines(" 7\n") == 16);
  CHECK(number_of_lines(" 8\n") == 16); // the other interface has no marked facets: the next number

  mesh.interface_cells.back()[0] = mesh.interface_cells.front()[0];
  CHECK_THROWS_AS(PM::IO::write_VTU(vtu, mesh), VMP::Input_error);
  mesh.interface_cells.pop_back();
  CHECK_THROWS_AS(PM::IO::write_VTU(vtu, mesh), VMP::Input_error);
}

// Under a limit of time, staircases come first.
TEST_CASE("A limit of time that is not reached changes nothing")
{
  for(const Body& body : { layered_box(), box_in_corner_of_layers() })
  {
    Hexahedron_soup_3 with_limit, without;
    const auto mesh = [&](Hexahedron_soup_3& hexahedra, const auto& np)
    { return PM::make_hexahedral_mesh_3(body.soup, body.images, 2, hexahedra, np); };
    const Hexahedral_mesh_result result = mesh(with_limit, CGAL::parameters::maximum_running_time(1e6));
    CHECK(mesh(without, CGAL::parameters::default_values()).message == result.message);
    CHECK(with_limit.points == without.points);
    CHECK_FALSE(result.is_interrupted);
  }
}
