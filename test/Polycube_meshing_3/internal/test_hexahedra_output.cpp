// Hexahedra in results and files.
#include "hexahedra_of_bodies.h"
#include "array_of_vtu_file.h"

#include <CGAL/Polycube_meshing_3/IO/write_hexahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

TEST_CASE("The patches of hexahedra of a box have its areas, centers and normals")
{
  Body box(4, 0, [](const Vector3d& p) -> Vector3d { return p.cwiseProduct(Vector3d(1, 2, 3)); });
  for(const auto& facet : VMP::internal::boundary_facets_3(box.soup.cells))
  {
    box.soup.facets.push_back(facet);
    const bool is_top = std::all_of(facet.begin(), facet.end(), [&](const std::size_t v) { return box.images[v][2] == 4; });
    box.soup.facet_references.push_back(is_top ? 9 : 2);
  }
  Hexahedron_soup_3 mesh;
  const Hexahedral_mesh_result result = PM::make_hexahedral_mesh_3(box.soup, box.images, 1, mesh);
  REQUIRE(result.patches.size() == 2);
  const PM::Hexahedral_mesh_patch& others = result.patches[0], & top = result.patches[1];
  CHECK(others.reference == 2);
  CHECK(others.number_of_quadrangles == 5 * 16);
  CHECK(std::abs(others.area - (2 * 4 * 12 + 2 * 8 * 12 + 4 * 8)) < 1e-9);
  CHECK(vector(others.normal).isApprox(Vector3d(0, 0, -1)));
  CHECK(top.reference == 9);
  CHECK(top.number_of_quadrangles == 16);
  CHECK(std::abs(top.area - 4 * 8) < 1e-9);
  CHECK(vector(top.center).isApprox(Vector3d(2, 4, 12)));
  CHECK(vector(top.normal).isApprox(Vector3d(0, 0, 1)));
}

TEST_CASE("Hexahedra are written for VTK and MEDIT")
{
  const Body box(1, 0, same);
  Hexahedron_soup_3 mesh;
  REQUIRE(box.mesh(1, mesh).status == VMP::OK);
  std::ostringstream medit, vtu;
  PM::IO::write_MEDIT(medit, mesh);
  CHECK(medit.str().find("Vertices\n8\n0 0 0 0\n") != std::string::npos);
  CHECK(medit.str().find("Hexahedra\n1\n1 2 3 4 5 6 7 8 0\nQuadrilaterals\n6\n1 ") != std::string::npos);
  PM::IO::write_VTU(vtu, mesh);
  const std::string text = vtu.str();
  CHECK(text.find("NumberOfPoints=\"8\" NumberOfCells=\"7\"") != std::string::npos);
  const auto connectivity = array_of<std::int32_t>(text, "connectivity", "Int32");
  CHECK(std::vector<std::int32_t>(connectivity.begin(), connectivity.begin() + 8)
        == std::vector<std::int32_t>{0, 1, 2, 3, 4, 5, 6, 7});
  CHECK(array_of<std::uint8_t>(text, "types", "UInt8") == std::vector<std::uint8_t>{12, 9, 9, 9, 9, 9, 9});
  CHECK(array_of<std::int64_t>(text, "offsets", "Int64") == std::vector<std::int64_t>{8, 12, 16, 20, 24, 28, 32});
  CHECK(array_of(text, "scaled_jacobian")[0] == Approx(1));
  CHECK(array_of(text, "uvw")[3 * 6 + 1] == 1);
  CHECK(array_of<std::int32_t>(text, "face", "Int32") == std::vector<std::int32_t>{0, 1, 2, 3, 4, 5, 6});
}

TEST_CASE("Quadrangles of the boundary are closed, seen from outside, and tell their face of the domain")
{
  for(const Body& body : { l_shaped_bar(), Body(8, 0, rounded), disc_with_stem() })
  {
    Hexahedron_soup_3 mesh;
    const bool has_padding = body.mesh(1, mesh).has_padding;
    const std::vector<int> numbers = boundary_quadrangles_of_cells(mesh);
    CHECK(mesh.facets.size() == static_cast<std::size_t>(std::accumulate(numbers.begin(), numbers.end(), 0)));
    REQUIRE(mesh.facet_cells.size() == mesh.facets.size());
    REQUIRE(mesh.polycube_faces.size() == mesh.facets.size());
    std::map<std::array<std::size_t, 2>, int> edges;
    std::map<std::size_t, std::set<std::size_t> > vertices_of_face;
    for(std::size_t f = 0; f < mesh.facets.size(); ++f)
    {
      const auto& cell = mesh.cells[mesh.facet_cells[f]];
      for(std::size_t i = 0; i < 4; ++i)
      {
        const std::size_t v = mesh.facets[f][i], w = mesh.facets[f][(i + 1) % 4];
        CHECK(std::count(cell.begin(), cell.end(), v) == 1);
        ++edges[{ v, w }];
        --edges[{ w, v }];
        vertices_of_face[mesh.polycube_faces[f]].insert(v);
      }
    }
    for(const auto& edge : edges)
      CHECK(edge.second == 0);
    CHECK(enclosed_volume(mesh) > 0);

    const bool is_ball = mesh.cells.size() == 512 + 384;
    CHECK(vertices_of_face.size() == (is_ball ? 6 : has_padding ? 11 : 8));
    CHECK(vertices_of_face.begin()->first == 1);
    for(const auto& [face, vertices] : vertices_of_face)
    {
      std::array<std::set<double>, 3> planes;
      for(const std::size_t v : vertices)
        for(std::size_t axis = 0; axis < 3; ++axis)
          planes[axis].insert(mesh.images[v][axis]);
      const std::size_t fewest = (std::min)({ planes[0].size(), planes[1].size(), planes[2].size() });
      CHECK((fewest == 1 || has_padding)); // vertices of the ball leave the edges of the cube
    }
    const VMP::Volume_map_3 map(body.soup.points, body.soup.cells, body.images);
    for(std::size_t v = 0; v < mesh.points.size(); ++v)
    {
      const auto point = map.nearest_preimage({ mesh.images[v][0], mesh.images[v][1], mesh.images[v][2] })->point;
      CHECK((Vector3d(point.x(), point.y(), point.z()) - vector(mesh.points[v])).norm() < 1e-12);
    }
  }
}

TEST_CASE("Hexahedra know the subdomain that their centers are mapped to")
{
  const auto cube = cube_mesh(2, 0);
  Tetrahedron_soup_3 soup = source_soup(cube);
  for(std::size_t c = 0; c < soup.cells.size(); ++c)
  {
    double x = 0;
    for(const std::size_t v : soup.cells[c])
      x += soup.points[v][0] / 4;
    soup.cell_references[c] = x < 1 ? 7 : 5;
  }
  Cube_complex<> complex(cube, soup);
  for(std::size_t v = 0; v < complex.vertices.size(); ++v)
    complex.uvw.emplace(complex.vertices[v], complex.vertices[v]->point());
  Hexahedron_soup_3 mesh;
  REQUIRE(PM::make_hexahedral_mesh_3(complex.c3t3, complex.uvw_map(), 1, mesh).status == VMP::OK);
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
    CHECK(mesh.cell_references[c] == (mesh.points[mesh.cells[c][0]][0] < 0.5 ? 7 : 5));
  std::ostringstream medit;
  PM::IO::write_MEDIT(medit, mesh);
  CHECK(medit.str().find(" 7\n", medit.str().find("Hexahedra")) != std::string::npos);
}

TEST_CASE("Quadrangles have the references of the facets that they lie on, of a soup and of a complex, in all files")
{
  const auto cube = cube_mesh(4, 0);
  Tetrahedron_soup_3 soup = source_soup(cube);
  soup.facets = VMP::internal::boundary_facets_3(soup.cells);
  soup.facet_references.clear();
  const auto reference = [](const Vector3d& center) // not those of the faces of the cube
  { return center[0] < 1e-9 ? 3 : center[2] > 4 - 1e-9 && center[1] < 2 ? 11 : center[2] > 4 - 1e-9 ? 12 : 0; };
  for(const auto& f : soup.facets)
  {
    const Vector3d sum = vector(soup.points[f[0]]) + vector(soup.points[f[1]]) + vector(soup.points[f[2]]);
    soup.facet_references.push_back(reference(sum / 3));
  }
  Hexahedron_soup_3 mesh, of_complex;
  REQUIRE(PM::make_hexahedral_mesh_3(soup, soup.points, 1, mesh).status == VMP::OK);
  REQUIRE(mesh.facets.size() == 96);
  for(std::size_t f = 0; f < mesh.facets.size(); ++f)
  {
    const Vector3d sum = vector(mesh.points[mesh.facets[f][0]]) + vector(mesh.points[mesh.facets[f][2]]);
    CHECK(mesh.facet_references[f] == reference(sum / 2));
  }
  CHECK(std::count(mesh.facet_references.begin(), mesh.facet_references.end(), 11) == 8);

  Cube_complex<> complex(cube, soup);
  for(std::size_t v = 0; v < complex.vertices.size(); ++v)
    complex.uvw.emplace(complex.vertices[v], complex.vertices[v]->point());
  REQUIRE(PM::make_hexahedral_mesh_3(complex.c3t3, complex.uvw_map(), 1, of_complex).status == VMP::OK);
  std::vector<int> references = mesh.facet_references;
  std::replace(references.begin(), references.end(), 0, 1); // the boundary of a complex has no facet without a patch
  CHECK(of_complex.facet_references == references);

  std::ostringstream vtu, inp, medit;
  PM::IO::write_VTU(vtu, mesh);
  const auto surfaces = array_of<std::int32_t>(vtu.str(), "surface", "Int32");
  CHECK(std::vector<int>(surfaces.begin() + 64, surfaces.end()) == mesh.facet_references);
  PM::IO::write_INP(inp, mesh);
  for(const auto& [name, number] : { std::pair("SURFACE_3", 16), std::pair("SURFACE_11", 8), std::pair("SURFACE_12", 8) })
  {
    const std::size_t begin = inp.str().find(std::string("*SURFACE, TYPE=ELEMENT, NAME=") + name + "\n");
    REQUIRE(begin != std::string::npos);
    const std::string section = inp.str().substr(begin + 1, inp.str().find('*', begin + 1) - begin - 1);
    CHECK(std::count(section.begin(), section.end(), '\n') == number + 1);
    CHECK(inp.str().find(std::string("*NSET, NSET=") + name + "\n") != std::string::npos);
  }
  CHECK(inp.str().find("SURFACE_0") == std::string::npos);
  PM::IO::write_MEDIT(medit, mesh);
  CHECK(medit.str().find(" 12\n", medit.str().find("Quadrilaterals")) != std::string::npos);
}

namespace {

// Returns the sections of an input file of Abaqus: for each line that begins with an asterisk, the words behind, separated by
// commas.
std::map<std::string, std::vector<std::string> > sections_of_inp(const std::string& text)
{
  std::map<std::string, std::vector<std::string> > result;
  std::istringstream lines(text);
  std::string line, keyword, word;
  while(std::getline(lines, line))
  {
    if(line[0] == '*')
    {
      keyword = line;
      CHECK(result.emplace(keyword, std::vector<std::string>()).second);
      continue;
    }
    CHECK(std::count(line.begin(), line.end(), ',') <= 16);
    std::istringstream words(line);
    while(std::getline(words >> std::ws, word, ','))
    {
      CHECK(word.size() <= 20);
      result[keyword].push_back(word);
    }
  }
  return result;
}

} // namespace

TEST_CASE("Hexahedra are written for Abaqus, with faces in its numbering, and numbers of at most 20 characters")
{
  Hexahedron_soup_3 mesh;
  REQUIRE(l_shaped_bar().mesh(1, mesh).status == VMP::OK);
  for(std::array<double, 3>& p : mesh.points)
    p = { p[0] * 1e-5, p[1] * -1e-120, p[2] * 100. / 3 };
  mesh.cell_references.back() = 9;
  std::ostringstream out;
  PM::IO::write_INP(out, mesh);
  const auto sections = sections_of_inp(out.str());
  const std::string name = "hexahedra_of_a_type.inp";
  for(const std::string type : { "C3D8", "C3D8I", "C3D8R" })
  {
    CHECK(PM::IO::write_INP(name, mesh, type));
    std::ifstream file(name);
    auto sections_of_type = sections_of_inp(std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()));
    CHECK(sections_of_type.size() == sections.size());
    CHECK(sections_of_type.count("*ELEMENT, TYPE=" + type + ", ELSET=EALL") == 1);
  }
  std::remove(name.c_str());
  CHECK_THROWS_AS(PM::IO::write_INP(name, mesh, "C3D4"), CGAL::Precondition_exception);
  CHECK_FALSE(std::ifstream(name));
  CHECK_FALSE(PM::IO::write_INP("no/such/folder.inp", mesh));

  // groups are sets, too, each by a name of its own that these programs take
  Hexahedron_soup_3 marked = mesh;
  marked.facet_references.front() = 5;
  std::ostringstream with_groups;
  PM::IO::write_INP(with_groups, marked, "C3D8",
                     { { { 2, 5 }, "2nd face" }, { { 3, 0 }, "STEEL_1" }, { { 3, 9 }, "Steel 1" }, { { 3, 77 }, "of no cell" } });
  auto named = sections_of_inp(with_groups.str());
  CHECK(named.at("*ELSET, ELSET=STEEL_1") == sections.at("*ELSET, ELSET=SUBDOMAIN_0"));
  CHECK(named.at("*ELSET, ELSET=Steel_1_2") == sections.at("*ELSET, ELSET=SUBDOMAIN_9"));
  CHECK(named.at("*NSET, NSET=GROUP_2nd_face") == named.at("*NSET, NSET=SURFACE_5"));
  CHECK(named.at("*SURFACE, TYPE=ELEMENT, NAME=GROUP_2nd_face") == named.at("*SURFACE, TYPE=ELEMENT, NAME=SURFACE_5"));
  CHECK(named.size() == sections.size() + 6); // these, and two of SURFACE_5

  // names that are possible stay, those of the package give way, and equal names are one group
  marked.facet_references[1] = 6;
  marked.facet_references[2] = 7;
  const std::map<std::pair<int, int>, std::string> groups = { { { 2, 5 }, "FACE_1" }, { { 2, 6 }, "a b" }, { { 2, 7 }, "FACE_1" },
    { { 2, 8 }, "a-b" }, { { 2, 9 }, "a_b" }, { { 2, 10 }, "Gr\u00f6\u00dfe" }, { { 2, 11 }, "" }, { { 2, 12 }, "nall" },
    { { 2, 13 }, "A_B" }, { { 2, 14 }, std::string(90, 'x') }, { { 2, 15 }, std::string(91, 'x') }, { { 3, 0 }, "a_b" } };
  CHECK(PM::IO::names_in_INP(groups) == std::map<std::pair<int, int>, std::string>{
    { { 2, 5 }, "FACE_1" }, { { 2, 6 }, "a_b_2" }, { { 2, 7 }, "FACE_1" }, { { 2, 8 }, "a_b_3" }, { { 2, 9 }, "a_b" },
    { { 2, 10 }, "Gr__e" }, { { 2, 11 }, "GROUP_" }, { { 2, 12 }, "nall_2" }, { { 2, 13 }, "A_B_4" },
    { { 2, 14 }, std::string(80, 'x') }, { { 2, 15 }, std::string(70, 'x') + "_2" }, { { 3, 0 }, "a_b" } });
  CHECK(PM::IO::names_in_INP({ { { 1, 4 }, "load" }, { { 1, 5 }, "Corners" }, { { 2, 6 }, "load" }, { { 3, 0 }, "load" } })
        == std::map<std::pair<int, int>, std::string>{ // one set of nodes would have those of the curve and of the surface
          { { 1, 4 }, "load_2" }, { { 1, 5 }, "Corners_2" }, { { 2, 6 }, "load" }, { { 3, 0 }, "load" } });
  std::ostringstream with_faces;
  PM::IO::write_INP(with_faces, marked, "C3D8", groups);
  named = sections_of_inp(with_faces.str());
  std::vector<std::string> both = named.at("*SURFACE, TYPE=ELEMENT, NAME=SURFACE_5");
  const std::vector<std::string>& other = named.at("*SURFACE, TYPE=ELEMENT, NAME=SURFACE_7");
  both.insert(both.end(), other.begin(), other.end());
  CHECK(named.at("*SURFACE, TYPE=ELEMENT, NAME=FACE_1") == both); // not the face of the polycube
  CHECK(named.at("*SURFACE, TYPE=ELEMENT, NAME=a_b_2") == named.at("*SURFACE, TYPE=ELEMENT, NAME=SURFACE_6"));
  CHECK(named.at("*ELSET, ELSET=a_b") == sections.at("*ELSET, ELSET=SUBDOMAIN_0"));
  std::ostringstream vtu;
  PM::IO::write_VTU(vtu, marked, groups);
  CHECK(vtu.str().find("Name=\"a b\"") != std::string::npos);

  const std::vector<std::string>& nodes = sections.at("*NODE, NSET=NALL");
  REQUIRE(nodes.size() == 4 * mesh.points.size());
  for(std::size_t i = 0; i < nodes.size(); ++i)
    if(i % 4 == 0)
      CHECK(std::stoul(nodes[i]) == i / 4 + 1);
    else
      CHECK(std::stod(nodes[i]) == Approx(mesh.points[i / 4][i % 4 - 1]).epsilon(1e-12));
  const std::vector<std::string>& elements = sections.at("*ELEMENT, TYPE=C3D8, ELSET=EALL");
  REQUIRE(elements.size() == 9 * mesh.cells.size());
  for(std::size_t i = 0; i < elements.size(); ++i)
    CHECK(std::stoul(elements[i]) == 1 + (i % 9 == 0 ? i / 9 : mesh.cells[i / 9][i % 9 - 1]));
  CHECK(sections.at("*ELSET, ELSET=SUBDOMAIN_0").size() == mesh.cells.size() - 1);
  CHECK(sections.at("*ELSET, ELSET=SUBDOMAIN_9") == std::vector<std::string>{ std::to_string(mesh.cells.size()) });

  // the nodes of faces of elements, from the manual of CalculiX
  constexpr std::size_t nodes_of_face[6][4]
    = { {1, 2, 3, 4}, {5, 8, 7, 6}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 8, 4}, {4, 8, 5, 1} };
  std::size_t number_of_facets = 0;
  for(std::size_t number = 1; number <= 8; ++number)
  {
    const std::string name = "FACE_" + std::to_string(number);
    const std::vector<std::string>& surface = sections.at("*SURFACE, TYPE=ELEMENT, NAME=" + name);
    std::set<std::string> nodes_of_surface;
    std::set<std::set<std::size_t> > faces, expected;
    for(std::size_t i = 0; i < surface.size(); i += 2)
    {
      std::set<std::size_t> face;
      for(const std::size_t node : nodes_of_face[std::stoul(surface[i + 1].substr(1)) - 1])
        face.insert(mesh.cells[std::stoul(surface[i]) - 1][node - 1]);
      for(const std::size_t v : face)
        nodes_of_surface.insert(std::to_string(v + 1));
      faces.insert(face);
    }
    for(std::size_t f = 0; f < mesh.facets.size(); ++f)
      if(mesh.polycube_faces[f] == number)
        expected.emplace(mesh.facets[f].begin(), mesh.facets[f].end());
    CHECK(faces == expected);
    number_of_facets += faces.size();
    const std::vector<std::string>& set = sections.at("*NSET, NSET=" + name);
    CHECK(std::set<std::string>(set.begin(), set.end()) == nodes_of_surface);
    CHECK(set.size() == nodes_of_surface.size());
  }
  CHECK(number_of_facets == mesh.facets.size());
}
