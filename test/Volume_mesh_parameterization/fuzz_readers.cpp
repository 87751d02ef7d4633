// Gives the readers of files damaged text by libFuzzer, and checks what they promise for any text. The name of the program is that
// of a reader, as readers() lists them. `MEDIT FOLDER OPTIONS` writes
// seeds to the folder, and begins with its files. scripts/test_matrix.sh runs all of them.
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/IO/boundary_targets.h>
#include <CGAL/Volume_mesh_parameterization/IO/read_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/IO/vertex_conditions.h>

#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>

namespace VMP = CGAL::Volume_mesh_parameterization;

using Points = std::vector<std::array<double, 3> >;

// A cube of six tetrahedra with all that a file can hold.
const VMP::Tetrahedron_soup_3& cube()
{
  static const VMP::Tetrahedron_soup_3 result = []()
  {
    VMP::Tetrahedron_soup_3 soup;
    soup.points = { {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1} };
    soup.cells = { {0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6} };
    soup.cell_references = { 1, 1, 2, 2, 3, 3 };
    soup.facets = { {0, 1, 2}, {0, 2, 3}, {4, 5, 6} };
    soup.facet_references = { 7, 7, 8 };
    soup.edges = { {0, 1}, {1, 2} };
    soup.edge_references = { 1, 1 };
    soup.corners = { 0, 6 };
    soup.group_names = { { {2, 7}, "bottom" }, { {3, 1}, "steel" } };
    soup.point_data = { { "temperature", 1, false, { 0, 1, 2, 3, 4, 5, 6, 7 } } };
    return soup;
  }();
  return result;
}

void expect(const bool condition, const char* promise)
{
  if(condition)
    return;
  std::cerr << "broken promise: " << promise << std::endl;
  std::abort();
}

bool are_finite(const Points& points)
{
  for(const std::array<double, 3>& p : points)
    for(const double x : p)
      if(!std::isfinite(x))
        return false;
  return true;
}

void read_mesh(const std::string& filename)
{
  VMP::Tetrahedron_soup_3 soup, again;
  VMP::IO::read_tetrahedron_soup(filename, soup);
  VMP::internal::check_simplices(soup);
  expect(are_finite(soup.points), "coordinates are finite");
  std::stringstream text;
  VMP::IO::write_MEDIT(text, soup);
  VMP::IO::read_MEDIT(text, again);
  expect(soup.points == again.points && soup.cells == again.cells && soup.facets == again.facets && soup.edges == again.edges
         && soup.corners == again.corners && soup.cell_references == again.cell_references, "a mesh is read as it was written");
}

void read_targets(const std::string& filename)
{
  Points targets;
  VMP::IO::read_boundary_targets(filename, cube(), targets);
  expect(targets.size() == cube().points.size(), "there is a target or none for each vertex");
}

void read_surface(const std::string& filename)
{
  const VMP::Tetrahedron_soup_3 soup = VMP::internal::read_surface(filename, VMP::internal::Budget());
  for(const std::array<std::size_t, 3>& facet : soup.facets)
    for(const std::size_t v : facet)
      expect(v < soup.points.size(), "triangles have vertices of the surface");
}

void read_features(const std::string& filename)
{
  VMP::Tetrahedron_soup_3 soup = cube();
  VMP::IO::read_features(filename, soup);
  VMP::internal::check_simplices(soup);
}

void read_conditions(const std::string& filename)
{
  std::vector<VMP::Vertex_condition_3> conditions;
  Points targets = cube().points;
  VMP::IO::read_vertex_conditions(filename, cube(), conditions, targets);
  expect(conditions.size() == cube().points.size(), "there is a condition for each vertex");
  expect(are_finite(targets), "targets are finite");
  for(const VMP::Vertex_condition_3& condition : conditions)
    expect(are_finite({ condition.direction() }), "directions are finite");
}

// Two sections as a binary file of MEDIT.
std::string binary_MEDIT()
{
  std::string bytes;
  const auto add = [&](const auto number) { bytes.append(reinterpret_cast<const char*>(&number), sizeof(number)); };
  const auto section = [&](const std::int32_t keyword, const std::size_t size)
  {
    add(keyword);
    add(static_cast<std::int32_t>(bytes.size() + 4 + size));
  };
  add(std::int32_t(1));
  add(std::int32_t(2));
  section(3, 4);
  add(std::int32_t(3));
  section(4, 4 + 8 * (3 * 8 + 4));
  add(std::int32_t(8));
  for(const std::array<double, 3>& p : cube().points)
  {
    for(const double x : p)
      add(x);
    add(std::int32_t(0));
  }
  section(8, 4 + 6 * 5 * 4);
  add(std::int32_t(6));
  for(const std::array<std::size_t, 4>& cell : cube().cells)
  {
    for(const std::size_t v : cell)
      add(static_cast<std::int32_t>(v + 1));
    add(std::int32_t(5));
  }
  add(std::int32_t(54));
  add(std::int32_t(0));
  return bytes;
}

std::string written(const std::function<void(std::ostream&)>& write)
{
  std::ostringstream os;
  write(os);
  return os.str();
}

std::vector<std::string> meshes()
{
  const std::string text = written([](std::ostream& os) { VMP::IO::write_MEDIT(os, cube()); });
  return { text, binary_MEDIT(), text.substr(0, text.find("Tetrahedra")) + "TetrahedraP2\n1\n1 2 3 7 1 1 1 1 1 1 9\nEnd\n" };
}

std::vector<std::string> VTU_files()
{
  const std::string text = R"(<VTKFile type="UnstructuredGrid" version="0.1"><UnstructuredGrid>
<Piece NumberOfPoints="4" NumberOfCells="1"><Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">10</DataArray>
</Cells><CellData><DataArray type="Int32" Name="material" format="binary">BAAAAAUAAAA=</DataArray></CellData></Piece>
</UnstructuredGrid></VTKFile>)";
  std::string compressed = text;
  const std::string type = "<VTKFile ", connectivity = "format=\"ascii\">0 1 2 3";
  compressed.replace(compressed.find(connectivity), connectivity.size(),
                     "format=\"binary\">AQAAACAAAAAAAAAAEwAAAA==eJxjYIAARijNBKWZoTQAAHAABw==");
  compressed.replace(0, type.size(), "<VTKFile compressor=\"vtkZLibDataCompressor\" ");
  return { written([](std::ostream& os) { VMP::IO::write_VTU(os, cube(), cube().points); }), text, compressed };
}

struct Reader
{
  std::string name;
  std::vector<std::string> seeds;
  void (*read)(const std::string& filename);
};

const std::vector<Reader>& readers()
{
  static const std::vector<Reader> result = {
    { "MEDIT", meshes(), read_mesh },
    { "VTU", VTU_files(), read_mesh },
    { "targets.txt", { "0 0 0 0 # a comment\n1 1.5 0 -2e3\n7 0 1 1\n", meshes().front() }, read_targets },
    { "targets.csv", { "\"Points:0\",\"Points:1\",\"Points:2\",\"Point ID\"\n0,0,0,0\n1,0,0,3\n", "x,y,z\n0,0,1\n", "2,0,0,0\n" },
      read_targets },
    { "targets.vtp", { R"(<VTKFile type="PolyData"><PolyData><Piece NumberOfPoints="3" NumberOfPolys="1"><Points>
<DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 1 1 0</DataArray></Points><Polys>
<DataArray type="Int64" Name="connectivity" format="ascii">0 2 1</DataArray><DataArray type="Int64" Name="offsets" format="ascii">3
</DataArray></Polys></Piece></PolyData></VTKFile>)" }, read_targets },
    { "surface.off",
      { "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "OFF\n# a square\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n" },
      read_surface },
    { "surface.stl",
      { "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid t\n" },
      read_surface },
    { "surface.obj", { "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 -1//1\n" },
      read_surface },
    { "features", { "2\n0 1\n1 2\n", "0 6 # a diagonal\n" }, read_features },
    { "conditions",
      { "7 fixed\nbottom plane 0 0 1\n8 z=1\nvertex 3 free\nvertex 0 x=0.5 # a comment\n", "7 plane 1 1 1\n8 y=1e300\n",
        "bottom surface\n8 surface \"bottom.stl\"\n" },
      read_conditions } };
  return result;
}

const Reader* reader;
std::string file; // whose extension is that of the reader

extern "C" int LLVMFuzzerInitialize(const int* argc, char*** argv)
{
  const std::string name = std::filesystem::path((*argv)[0]).filename().string();
  for(const Reader& r : readers())
    if(r.name == name)
      reader = &r;
  expect(reader, "the program has the name of a reader");
  file = std::filesystem::temp_directory_path() / ("fuzz_" + std::to_string(getpid()) + name);
  if(*argc > 1 && std::filesystem::is_directory((*argv)[1]))
    for(std::size_t i = 0; i < reader->seeds.size(); ++i)
      std::ofstream(std::filesystem::path((*argv)[1]) / ("seed" + std::to_string(i)), std::ios::binary) << reader->seeds[i];
  std::atexit([]() { std::filesystem::remove(file); });
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, const std::size_t size)
{
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try
  {
    reader->read(file);
  }
  catch(const VMP::Input_error& error)
  {
    expect(*error.what() != '\0', "a refused file has a sentence");
  }
  return 0;
}
