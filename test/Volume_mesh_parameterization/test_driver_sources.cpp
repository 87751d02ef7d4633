// The program parameterize_mesh_file: what it reads of the files of other programs, and what it refuses.
#include "driver.h"
#include "Soup_bytes.h"

#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/IO/read_tetrahedron_soup.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

TEST_CASE("Vertices without a cell keep their place in the output")
{
  const Folder folder;
  Soup source = cube(2);
  source.points.insert(source.points.end(), {{7, 8, 9}, {4, 5, 6}});
  folder.write("source.mesh", source);
  folder.write("target.txt", boundary_lines(cube(2), 2, affine) + "28 0.1 0.2 0.3\n");
  CHECK(folder.run("source.mesh target.txt --output map.mesh") == 0);
  const Soup map = folder.soup("map.mesh");
  REQUIRE(map.points.size() == 29);
  CHECK(map.points[27] == Point{7, 8, 9});
  CHECK(map.points[28] == Point{0.1, 0.2, 0.3});
}

TEST_CASE("Bad input: exit code 2, a sentence and no output")
{
  const Folder folder;
  const Soup source = cube(2);
  const std::string target = boundary_lines(source, 2, affine);
  const std::string second_line = target.substr(target.find('\n') + 1);
  folder.write("source.mesh", source);
  folder.write("target.txt", target);
  const std::string mesh = folder.text("source.mesh");

  const auto sentence = [&folder](const std::string& files)
  {
    CHECK(folder.run(files + " --quiet --boundary fixed --output map.mesh --report report.json") == 2);
    CHECK(!fs::exists(folder.path("map.mesh")));
    CHECK(folder.text("stdout") == "");
    const std::string report = folder.text("report.json");
    const auto end_of_options = std::find(report_keys.begin(), report_keys.end(), "vertices");
    CHECK(keys(report) == std::vector<std::string>(report_keys.begin(), end_of_options));
    const std::string message = folder.text("stderr");
    CHECK(std::count(message.begin(), message.end(), '\n') == 1);
    const std::string sentence_in_report = "{\"status\": \"" + message.substr(0, message.size() - 1) + "\"";
    CHECK(report.find(sentence_in_report + ", \"status_code\": \"ERROR_") == 0);
    CHECK(report.find("\"has_valid_map\": false") != std::string::npos);
    return message;
  };

  CHECK(sentence("none.mesh target.txt") == "none.mesh: the file cannot be opened\n");
  CHECK(sentence("source.mesh none.txt") == "none.txt: the file cannot be opened\n");
  CHECK(sentence("target.txt target.txt").find("target.txt: line 1: this is not an ASCII MEDIT file") == 0);
  folder.write("mesh.xyz", "v 0 0 0\n");
  CHECK(sentence("mesh.xyz --to ball").find(
    "neither this program (see --help) nor meshio reads files with the extension '.xyz'") != std::string::npos);
  folder.write("mesh.pvtu", "<VTKFile type=\"PUnstructuredGrid\"><Piece Source='a.vtu'/><Piece Source='b.vtu'/></VTKFile>\n");
  CHECK(sentence("mesh.pvtu --to ball").find("UnstructuredGrid; this file is a list of pieces") != std::string::npos);
  folder.write("mesh.med", "HDF");
  CHECK(sentence("mesh.med --to ball").find("; other formats can be converted: meshio convert mesh.med mesh.vtu\n")
        != std::string::npos);
  folder.write("mesh.off", "OFF\n");
  folder.write("mesh.STEP", "ISO-10303-21;\n");
  if(fs::exists(PARAMETERIZE_MESH_FILE "_Gmsh.so"))
  {
    CHECK(sentence("mesh.off --to ball") == "mesh.off: the surface cannot be read\n");
    CHECK(sentence("mesh.STEP --to ball").find("mesh.STEP: Gmsh says: Could not read file 'mesh.STEP'; save the solids ") == 0);
  }
  else
  {
    CHECK(sentence("mesh.off --to ball").find("; this is a surface; a volume mesher fills it: tetgen -pqg mesh.off writes "
                                              "mesh.1.mesh\n") != std::string::npos);
    CHECK(sentence("mesh.STEP --to ball").find(": gmsh -3 mesh.STEP -o mesh.mesh fills it.") != std::string::npos);
  }
  CHECK(folder.run("source.mesh --to ball --cells 1") == 2);
  CHECK(folder.text("stderr").find("--cells and --tetrahedra need a source that is filled") == 0);
  CHECK(folder.run("none.step --to ball --cells=-1") == 2);
  CHECK(folder.text("stderr").find("the size of cells (--cells) must be a finite number") == 0);
  folder.write("mesh.vtu", "<?xml version=\"1.0\"?>\n");
  CHECK(sentence("mesh.vtu --to ball") == "mesh.vtu: this is not a VTK XML file of the type UnstructuredGrid\n");

  folder.write("bad.mesh", mesh.substr(0, mesh.find("Tetrahedra\n48\n") + 20));
  CHECK(sentence("bad.mesh target.txt").find("bad.mesh: line 34: the file ends where") == 0);

  Soup bad = source;
  bad.points[13] = {1, 1, 2.5}; // through the boundary
  folder.write("bad.mesh", bad);
  CHECK(sentence("bad.mesh target.txt").find("(counted from 0) has the negative volume") != std::string::npos);
  bad = source;
  bad.cells.push_back({0, 9, 12, 14}); // a part of two others
  bad.cell_references.push_back(bad.cell_references[4]);
  folder.write("bad.mesh", bad);
  for(const std::string target : { "target.txt", "--to ball" })
    CHECK(sentence("bad.mesh " + target).find(" overlap, they lie on the same side of their common facet") != std::string::npos);

  folder.write("bad.txt", second_line);
  CHECK(sentence("source.mesh bad.txt")
        == "bad.txt: vertex 0 (counted from 0) is on the boundary of the source, but has no target. --others stay keeps the "
          "positions of such vertices; --others slide lets them slide in planes of the boundary\n");
  folder.write("bad.txt", "0 0 0 nan\n" + second_line);
  CHECK(sentence("source.mesh bad.txt") == "bad.txt: line 1: 'nan' is not a finite coordinate\n");
  folder.write("bad.txt", boundary_lines(source, 2, [](const Point& p) { return Point{p[0], p[1], -p[2]}; }));
  CHECK(sentence("source.mesh bad.txt") != "");
  // a corner with a cell whose vertices are all on the boundary
  folder.write("bad.txt", boundary_lines(source, 2, [](const Point& p)
  {
    return p == Point{2, 0, 0} ? Point{1.2, 0.8, 0} : p;
  }));
  CHECK(sentence("source.mesh bad.txt") != "");
}

TEST_CASE("The content of files of other programs tells what helps, whatever their names are")
{
  const Folder folder;
  const auto sentence = [&](const std::string& name, const std::string& content)
  {
    folder.write(name, content);
    CHECK(folder.run("'" + name + "' --to ball") == 2);
    return folder.text("stderr");
  };
  const std::string nodes = "*NODE, NSET=Nall\n1,0,0,0\n", no_route = "Neither this program nor meshio reads it";
  CHECK(sentence("a b.msh", "** of cgx\n\n" + nodes)
        == "a b.msh: this is a file of Abaqus; it can be converted: meshio convert --input-format abaqus 'a b.msh' 'a b.vtu'\n");
  CHECK(sentence("mesh.inp", nodes).find("can be converted: meshio convert mesh.inp mesh.vtu\n") != std::string::npos);
  CHECK(sentence("mesh.inp", "# of AVS\n4 1 0 0 0\n1 0 0 0\n").find(
    "mesh.inp: this is a file of AVS; it can be converted: meshio convert --input-format avsucd mesh.inp mesh.vtu\n") == 0);
  CHECK(sentence("mesh.msh", "(0 \"Fluent\")\n(2 3)\n").find("mesh.msh: this is a mesh of Fluent. ParaView reads it under") == 0);
  CHECK(sentence("mesh.e", "CDF\x02").find("this is a file of Exodus; it can be converted: python3 -c ")
        != std::string::npos);
  folder.write("mesh.1.ele", "1 10 0\n0 0 1 2 3 4 5 6 7 8 9\n");
  for(const char* name : { "mesh.1.ele", "mesh.1.node" })
    CHECK(sentence(name, name == std::string("mesh.1.ele") ? folder.text(name) : "10 3 0 0\n").find(
      "of second order; it can be converted: tetgen -rg mesh.1 writes mesh.2.mesh\n") != std::string::npos);
  CHECK(sentence("mesh.ele", "1 4 0\n0 0 1 2 3\n").find("meshio convert mesh.ele mesh.vtu\n") != std::string::npos);
  for(const auto& [program, name, content] : { std::array<std::string, 3>{ "LS-DYNA", "mesh.k", "$ text\n*KEYWORD\n*NODE\n" },
                                               { "Ansys", "mesh.cdb", "/COM,ANSYS\n/PREP7\nNBLOCK,6\n" },
                                               { "FEBio", "mesh.feb", "<?xml version=\"1.0\"?>\n<febio_spec version=\"4.0\">\n" },
                                               { "OpenFOAM", "points", "/* */\nFoamFile\n{\n}\n" } })
    CHECK(sentence(name, content).find(name + ": this is a file of " + program + ". " + no_route) == 0);
  fs::create_directory(folder.path("polyMesh"));
  folder.write("polyMesh/faces", "FoamFile");
  folder.write("polyMesh/owner", "FoamFile");
  CHECK(folder.run("polyMesh --to ball") == 2);
  CHECK(folder.text("stderr").find("polyMesh: this is a mesh of OpenFOAM. " + no_route) == 0);
}

namespace {

// A script of Gmsh for a beam of two solids that share a face, with the size 1 x 1 x 2.
const std::string beam_script = "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 1, 1, 1};\nBox(2) = {0, 0, 1, 1, 1, 1};\n"
  "BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }\n";

} // namespace

TEST_CASE("Gmsh fills the body of a script or of a closed surface with tetrahedra")
{
  if(!fs::exists(PARAMETERIZE_MESH_FILE "_Gmsh.so"))
    return;
  const Folder folder;
  folder.write("beam.geo", beam_script);
  CHECK(folder.run("beam.geo --cells 0.5 --to polycube --hexahedra 0.5 beam.inp --tetrahedra beam.mesh") == 0);
  const Soup beam = folder.soup("beam.mesh");
  CHECK(std::set<int>(beam.cell_references.begin(), beam.cell_references.end()) == std::set<int>{ 1, 2 });
  const std::set<int> faces(beam.facet_references.begin(), beam.facet_references.end());
  CHECK(faces.size() == 11); // one of them between the solids
  for(const auto& [u, v] : beam.edges) // of curves, on which two coordinates are integers
    CHECK(std::count_if(beam.points[u].begin(), beam.points[u].end(), [](const double x)
                        { return std::abs(x - std::round(x)) < 1e-9; }) >= 2);
  CHECK(beam.edges.size() >= 20);
  CHECK(folder.text("beam.inp").find("*SURFACE, TYPE=ELEMENT, NAME=INTERFACE_1_2\n") != std::string::npos);
  CHECK(folder.run("beam.geo --cells 0.15 --to box=1,1,2 --tetrahedra finer.mesh") == 0);
  CHECK(folder.soup("finer.mesh").cells.size() > 2 * beam.cells.size());

  // a cube with a cavity, and what is wrong with other surfaces
  const auto write_cubes = [&](const std::string& name, const std::vector<std::array<double, 2> >& cubes,
                               const std::size_t left_out = 0)
  {
    std::ostringstream points, triangles;
    std::size_t first = 0, number = 0;
    for(const auto& [origin, size] : cubes)
    {
      for(int i = 0; i < 8; ++i)
        points << origin + size * (i & 1) << " " << origin + size * (i >> 1 & 1) << " " << origin + size * (i >> 2) << "\n";
      for(const std::array<int, 4>& q : { std::array{ 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 },
                                          { 1, 3, 7, 5 } })
        if(number++ >= left_out)
          triangles << "4 " << first + q[0] << " " << first + q[1] << " " << first + q[2] << " " << first + q[3] << "\n";
      first += 8;
    }
    folder.write(name, "OFF\n" + std::to_string(first) + " " + std::to_string(number - left_out) + " 0\n" + points.str()
                         + triangles.str());
  };
  const auto sentence = [&](const std::vector<std::array<double, 2> >& cubes, const std::size_t left_out = 0)
  {
    write_cubes("cubes.off", cubes, left_out);
    CHECK(folder.run("cubes.off --cells 1 --to ball") == 2);
    return folder.text("stderr");
  };
  write_cubes("cavity.off", { { 0, 3 }, { 1, 1 } });
  folder.run("cavity.off --cells 1 --to ball --tetrahedra cavity.mesh"); // which is no ball
  const Soup cavity = folder.soup("cavity.mesh");
  CHECK(cavity.edges.empty());
  CHECK(cavity.facets.empty());
  const auto volume = [](const Soup& soup)
  {
    double sum = 0;
    for(const std::array<std::size_t, 4>& cell : soup.cells)
    {
      const auto vector = [&](const std::size_t i)
      {
        const Point &p = soup.points[cell[i]], &q = soup.points[cell[0]];
        return Point{ p[0] - q[0], p[1] - q[1], p[2] - q[2] };
      };
      const Point a = vector(1), b = vector(2), c = vector(3);
      sum += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
    }
    return sum;
  };
  CHECK(volume(cavity) == Approx(26));
  CHECK(folder.text("stderr").find(" If it is a void, --fill-voids fills it.\n") != std::string::npos);
  CHECK(folder.run("cavity.off --cells 1 --to ball --fill-voids --tetrahedra cavity.mesh") == 0);
  CHECK(folder.text("stderr").find("note: cavity.off: 1 void is filled\n") != std::string::npos);
  CHECK(volume(folder.soup("cavity.mesh")) == Approx(27));
  CHECK(sentence({ { 0, 1 } }, 1).find("cubes.off: the surface is not closed, because the edge between the points (") == 0);
  CHECK(sentence({ { 0, 2 }, { 1, 2 } }).find("cubes.off: the surface crosses itself near (") == 0);
  CHECK(sentence({ { 0, 2 }, { 1, 2 } }).find(". Unite the solids that cross there in a CAD program") != std::string::npos);
  // two bodies, one of them in a cavity of another one
  CHECK(sentence({ { 0, 9 }, { 3, 3 }, { 4, 1 }, { 10, 2 } }).find("note: cubes.off: the surface encloses 3 bodies") == 0);
  CHECK(folder.run("cubes.off --cells 1 --to polycube --refine=none --tetrahedra cubes.mesh") == 0);
  CHECK(volume(folder.soup("cubes.mesh")) == Approx(729 - 27 + 1 + 8));
  CHECK(folder.run("cubes.off --cells 1 --to polycube --refine=none --fill-voids --tetrahedra cubes.mesh") == 0);
  CHECK(folder.text("stderr").find("note: cubes.off: 1 void is filled\n") != std::string::npos);
  CHECK(volume(folder.soup("cubes.mesh")) == Approx(729 + 8));
  // a sphere with needles at its poles, whose triangles have the size of the cells then
  constexpr int number_of_meridians = 400, number_of_circles = 4, north = 1 + number_of_meridians * number_of_circles;
  std::ostringstream sphere;
  sphere << "OFF\n" << north + 1 << ' ' << 2 * number_of_meridians * number_of_circles << " 0\n0 0 -1\n";
  for(int j = 1; j <= number_of_circles; ++j)
    for(int i = 0; i < number_of_meridians; ++i)
    {
      const double t = CGAL_PI * j / (number_of_circles + 1), s = 2 * CGAL_PI * i / number_of_meridians;
      sphere << std::sin(t) * std::cos(s) << ' ' << std::sin(t) * std::sin(s) << ' ' << -std::cos(t) << '\n';
    }
  sphere << "0 0 1\n";
  for(int i = 0; i < number_of_meridians; ++i)
  {
    const auto vertex = [&](const int j, const int k) { return 1 + (j - 1) * number_of_meridians + k % number_of_meridians; };
    sphere << "3 0 " << vertex(1, i + 1) << ' ' << vertex(1, i) << '\n';
    sphere << "3 " << north << ' ' << vertex(number_of_circles, i) << ' ' << vertex(number_of_circles, i + 1) << '\n';
    for(int j = 1; j < number_of_circles; ++j)
    {
      sphere << "3 " << vertex(j, i) << ' ' << vertex(j, i + 1) << ' ' << vertex(j + 1, i + 1) << '\n';
      sphere << "3 " << vertex(j, i) << ' ' << vertex(j + 1, i + 1) << ' ' << vertex(j + 1, i) << '\n';
    }
  }
  folder.write("sphere.off", sphere.str());
  for(const std::string size : { "0.3", "100" }) // at most a tenth of the diagonal
  {
    CHECK(folder.run("sphere.off --cells " + size + " --to ball --refine=none --tetrahedra sphere.mesh") == 0);
    CHECK(volume(folder.soup("sphere.mesh")) == Approx(3.789).epsilon(0.05)); // the five bands have this volume
  }
  // points with the same place, and of a surface to which a body is fitted
  const std::string doubled = "v 0 0 0\nv 0 1 0\nv 1 1 0\nv 1 0 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 0 0 0\nv 1 0 0\nv 1 0 1\n"
                              "v 0 0 1\nv 1 0 0\nv 1 1 0\nv 1 1 1\nv 1 0 1\nv 1 1 0\nv 0 1 0\nv 0 1 1\nv 1 1 1\nv 0 1 0\nv 0 0 0\n"
                              "v 0 0 1\nv 0 1 1\nf 1 2 3 4\nf 5 6 7 8\nf 9 10 11 12\nf 13 14 15 16\nf 17 18 19 20\n"
                              "f 21 22 23 24\n";
  folder.write("doubled.obj", doubled);
  CHECK(folder.run("doubled.obj --cells 0.5 --to doubled.obj") == 0);
  CHECK(folder.text("stderr").find("note: doubled.obj: 16 points are joined to others with the same coordinates\n") == 0);
  folder.write("open.obj", doubled.substr(0, doubled.rfind("f 21")));
  CHECK(folder.run("doubled.obj --cells 0.5 --to open.obj") == 2);
  CHECK(folder.text("stderr").find("open.obj: the surface is not closed, because the edge between the points (0, ")
        != std::string::npos);

  // names of faces in a file of STEP, which Gmsh does not give
  folder.write("box.geo", "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 1, 1, 1};\nSave \"box.step\";\n");
  REQUIRE(folder.run("box.geo --cells 0.5 --to ball") == 0);
  CHECK(folder.run("box.step --cells 0.5 --to ball --merge-points=0.1") == 2);
  CHECK(folder.text("stderr").find("--merge-points=DISTANCE needs a mesh or a surface") == 0);
  CHECK(folder.run("box.step --cells 0.5 --to ball") == 0);
  CHECK(folder.text("stderr").find("name of faces") == std::string::npos);
  std::string named = folder.text("box.step");
  const std::string face = "ADVANCED_FACE('";
  REQUIRE(named.find(face) != std::string::npos);
  folder.write("named.step", named.insert(named.find(face) + face.size(), "support"));
  CHECK(folder.run("named.step --cells 0.5 --to ball") == 0);
  CHECK(folder.text("stderr").find("note: named.step: 1 name of faces is left out, because Gmsh does not give them") == 0);

  // a bore and a void that are smaller than cells, and a sheet beside a solid
  const std::string head = "SetFactory(\"OpenCASCADE\");\n";
  folder.write("bore.geo", head + "Box(1) = {0, 0, 0, 2, 2, 2};\nCylinder(2) = {-1, 1, 1, 4, 0, 0, 0.1};\n"
                           "Cylinder(3) = {1, -1, 1, 0, 4, 0, 0.1};\nSphere(4) = {0.4, 0.4, 0.4, 0.08};\n"
                           "BooleanDifference(5) = { Volume{1}; Delete; }{ Volume{2, 3, 4}; Delete; };\n"
                           "Rectangle(50) = {3, 0, 0, 1, 1};\n");
  CHECK(folder.run("bore.geo --cells 0.5 --to polycube -o bore.mesh") == 0);
  CHECK(folder.text("stderr").find("note: bore.geo: 1 face bounds no solid and is left out.") != std::string::npos);
  CHECK(folder.text("stderr").find("cylinders and spheres have a smaller diameter than the cells.") != std::string::npos);
  folder.write("fillet.geo", head + "Box(1) = {0, 0, 0, 2, 2, 2};\nFillet{1}{12}{0.003}\nCylinder(2) = {1, 1, -1, 0, 0, 4, 0.1};\n"
                             "BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };\n");
  CHECK(folder.run("fillet.geo --cells 0.5 --to polycube --tetrahedra fillet.mesh") == 0);
  CHECK(folder.soup("fillet.mesh").cells.size() < 10000); // 66,885 if edges around the bore are asked for at the fillet, too
  CHECK(folder.run("fillet.geo --cells 0.01 --to ball --time-limit 0.5") == 3);
  CHECK(folder.text("stderr") == "The time limit was reached. Gmsh has made no mesh yet. Larger cells (--cells) need less "
                                 "time.\n");
  CHECK(folder.run("bore.geo --cells 0.5 --to ball") == 2);
  CHECK(folder.text("stderr").find("The smallest one is around (0.40") != std::string::npos);
  CHECK(folder.text("stderr").find("If it is a void, fill it in a CAD program.\n") != std::string::npos);
  CHECK(folder.run("bore.geo --cells 0.5 --to ball --fill-voids") == 2);
  CHECK(folder.text("stderr").find("--fill-voids needs a source of a CAD program or a closed surface.") == 0);
  folder.write("hollow.geo", head + "Box(1) = {0, 0, 0, 1, 1, 1};\nSphere(2) = {0.3, 0.5, 0.5, 0.1};\n"
                             "Sphere(3) = {0.7, 0.5, 0.5, 0.1};\n"
                             "BooleanDifference(4) = { Volume{1}; Delete; }{ Volume{2, 3}; Delete; };\nSave \"hollow.step\";\n");
  CHECK(folder.run("hollow.geo --cells 0.5 --to ball") == 2);
  CHECK(folder.run("hollow.step --cells 0.5 --to ball") == 2);
  CHECK(folder.text("stderr").find(" If it is a void, --fill-voids fills it.\n") != std::string::npos);
  CHECK(folder.run("hollow.step --cells 0.5 --to ball --fill-voids --tetrahedra hollow.mesh") == 0);
  CHECK(folder.text("stderr").find("note: hollow.step: 2 voids are filled\n") == 0);
  CHECK(volume(folder.soup("hollow.mesh")) == Approx(1));
  // a boundary that the program prescribes itself, and misses
  folder.write("angle.geo", head + "Box(1) = {0, 0, 0, 4, 1, 1};\nBox(2) = {0, 0, 0, 1, 1, 4};\n"
                            "BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };\nSave \"angle.step\";\n");
  CHECK(folder.run("angle.geo --cells 0.7 --to cube --refine=none") == 1);
  CHECK(folder.text("stderr").find(". Allow refinement (--refine). Cells of another size (--cells) may have a map.\n")
        != std::string::npos);
  CHECK(folder.run("angle.step --cells 0.7 --to cube --refine=none") == 1);
  CHECK(folder.text("stderr").find(" may have a map, and so may the body without the voids inside, if it has some: --fill-voids "
                                   "fills them.\n") != std::string::npos);
  // a script that makes no solid in the four runs of two attempts
  folder.write("third.geo", head + "run = 1;\nFor i In {1 : 4}\nIf(FileExists(Sprintf(\"run%g\", i)))\nrun = i + 1;\nEndIf\n"
                            "EndFor\nPrintf(\"\") > Sprintf(\"run%g\", run);\nIf(run > 4)\nBox(1) = {0, 0, 0, 4, 4, 4};\nEndIf\n");
  CHECK(folder.run("third.geo --cells 1 --to ball --tetrahedra third.mesh") == 0);
  CHECK(folder.text("stderr").find("note: third.geo: Gmsh failed in its first attempt. Another one, with cells of twice the size, "
                                   "succeeded\n") == 0);
  CHECK(folder.run("third.geo --cells 2 --to ball --tetrahedra larger.mesh") == 0);
  CHECK(folder.soup("third.mesh").cells.size() == folder.soup("larger.mesh").cells.size());
  CHECK(folder.run("none.step --to ball") == 2);
  CHECK(folder.text("stderr") == "none.step: the file cannot be opened\n");
  folder.write("flat.geo", "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 1, 1};\n");
  CHECK(folder.run("flat.geo --to ball") == 2);
  CHECK(folder.text("stderr").find("flat.geo: the file contains no solid") == 0);
  folder.write("endless.geo", "For i In {0 : 1e9}\nEndFor\n");
  CHECK(folder.run("endless.geo --to ball --time-limit 0.5") == 3);
}

TEST_CASE("Marks of corners that contradict the shape everywhere are noted, and do not count")
{
  const Folder folder;
  Soup source = cube(4);
  const std::vector<std::size_t> boundary = VMP::boundary_vertices(source.points, source.cells);
  source.corners = boundary;
  folder.write("source.mesh", source);
  CHECK(folder.run("source.mesh --to polycube --hexahedra 2 hexahedra.mesh") == 0);
  CHECK(folder.text("stderr").find("note: source.mesh: 90 vertices are marked as corners at places where the boundary has no "
                                   "corner. The marks of corners are left out; TetGen makes such marks\n") != std::string::npos);
  source.corners = { boundary[0], boundary[1] }; // of which one is at an edge of the cube
  folder.write("source.mesh", source);
  CHECK(folder.run("source.mesh --to polycube --hexahedra 2 hexahedra.mesh") == 0);
  CHECK(folder.text("stderr").find("marked as corners at places") == std::string::npos);
}

TEST_CASE("Names that Abaqus cannot hold are noted, old and new")
{
  const Folder folder;
  Soup source = cube(2);
  source.facets = { { 0, 1, 4 } };
  for(const std::array<std::size_t, 4>& cell : source.cells)
    for(const std::array<std::size_t, 3>& f : { std::array{ cell[1], cell[2], cell[3] }, { cell[0], cell[2], cell[3] },
                                                { cell[0], cell[1], cell[3] }, { cell[0], cell[1], cell[2] } })
      if(std::all_of(f.begin(), f.end(), [&](const std::size_t v) { return source.points[v][0] == 0; }))
        source.facets.push_back(f);
  source.facets.erase(source.facets.begin());
  source.facet_references.assign(source.facets.size(), 7);
  source.group_names = { { { 2, 7 }, "top wall" }, { { 3, source.cell_references[0] }, "steel" } };
  std::ofstream os(folder.path("source.vtu"), std::ios::binary);
  VMP::IO::write_VTU(os, source, source.points);
  os.close();
  CHECK(folder.run("source.vtu --to polycube --hexahedra 1 hexahedra.inp") == 0);
  CHECK(folder.text("stderr").find("note: hexahedra.inp: the group 'top wall' has the name top_wall\n") != std::string::npos);
  CHECK(folder.text("stderr").find("steel") == std::string::npos);
  CHECK(folder.text("hexahedra.inp").find("NAME=top_wall\n") != std::string::npos);
  CHECK(folder.run("source.vtu --to polycube --hexahedra 1 hexahedra.vtu") == 0);
  CHECK(folder.text("stderr").find("top wall") == std::string::npos);
  CHECK(folder.text("hexahedra.vtu").find("Name=\"top wall\"") != std::string::npos);
}

namespace {

// One tetrahedron in formats that Gmsh and VTK read, in which a test replaces numbers.
const std::string msh_file = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n"
  "0 1 0\n0 0 1\n$EndNodes\n$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 3 4\n$EndElements\n";
const std::string unv_file = "    -1\n  2411\n         1         1         1        11\n  0 0 0\n"
  "         2         1         1        11\n  1 0 0\n         3         1         1        11\n  0 1 0\n"
  "         4         1         1        11\n  0 0 1\n    -1\n    -1\n  2412\n"
  "         1       111         1         1         7         4\n         1         2         3         4\n    -1\n";
const std::string vtk_file = "# vtk DataFile Version 5.1\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n"
  "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 2 4\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n0 1 2 3\nCELL_TYPES 1\n10\n";

} // namespace

TEST_CASE("A damaged file on which a library crashes, or takes all memory, is refused by a sentence with its name")
{
  const Folder folder;
  const auto status = [&](const std::string& name, const std::string& text)
  {
    folder.write(name, text);
    return folder.run(name + " --improve --quiet");
  };
  const auto is_refused = [&](const std::string& name, const std::string& text, const std::string& part, const std::string& other,
                              const std::string& sentence)
  {
    REQUIRE(status(name, text) == 0);
    CHECK(status(name, text.substr(0, text.rfind(part)) + other + text.substr(text.rfind(part) + part.size())) == 2);
    CHECK(folder.text("stderr").find(name + ": " + sentence) == 0);
  };
  if(fs::exists(PARAMETERIZE_MESH_FILE "_Gmsh.so"))
  {
    is_refused("cell.msh", msh_file, "3 4", "3 -1", "Gmsh crashed (Segmentation fault)");
    is_refused("cell.msh", msh_file, "0 4\n", "0 100000000000\n",
               "Gmsh ran out of memory on a file of " + std::to_string(msh_file.size() + 11) + " bytes; the file contains the "
               "number 100000000000\n");
    is_refused("cell.unv", unv_file, " 4", "-1", "Gmsh crashed (Segmentation fault)");
  }
  if(status("cell.vtk", vtk_file) == 0)
  {
    is_refused("cell.vtk", vtk_file, "POINTS 4", "POINTS 100000000000",
               "VTK cannot read the file. Unable to allocate 300000000003 elements");
    is_refused("cell.vtk", vtk_file, "0 4\nC", "0 400000000\nC", "the offset 400000000 of cell 0 (counted from 0) is wrong");
    is_refused("cell.vtk", vtk_file, "0 1 0 0", "0 x 0 0", "VTK cannot read the file. Error reading ascii data");
    REQUIRE(mkfifo(folder.path("pipe.vtk").c_str(), 0600) == 0); // nobody writes, and VTK waits
    CHECK(folder.run("pipe.vtk --improve --time-limit 0.2") == 3);
    CHECK(folder.text("stderr") == "The time limit was reached. There is no map yet.\n");
  }
}

TEST_CASE("A mesh that another process reads keeps all that it has")
{
  Soup soup = cube(1);
  soup.facets = { { 0, 1, 2 } };
  soup.facet_references = { -3 };
  soup.edges = { { 0, 1 }, { 1, 2 } };
  soup.edge_references = { 4, 5 };
  soup.corners = { 7 };
  soup.group_names = { { { 3, 1 }, "bone" }, { { 2, -3 }, "" } };
  soup.point_data = { { "T", 1, true, { 1, 2, 3, 4, 5, 6, 7, 8 } } };
  soup.cell_data = { { "v", 3, false, std::vector<double>(18, 0.1) } };
  soup.facet_data = { { "f", 1, false, { 0.5 } } };
  soup.edge_data = { { "e", 1, false, { 2, 3 } } };
  soup.notes = { "a note", "another" };
  const std::string bytes = Soup_bytes(soup).bytes();
  Soup other = Soup_bytes(bytes).restored();
  CHECK(other.points == soup.points);
  CHECK(other.cells == soup.cells);
  CHECK(other.cell_references == soup.cell_references);
  CHECK(other.facets == soup.facets);
  CHECK(other.facet_references == soup.facet_references);
  CHECK(other.edges == soup.edges);
  CHECK(other.edge_references == soup.edge_references);
  CHECK(other.corners == soup.corners);
  CHECK(other.group_names == soup.group_names);
  CHECK(other.notes == soup.notes);
  CHECK(other.point_data.at(0).has_integers);
  CHECK(other.cell_data.at(0).number_of_components == 3);
  CHECK(other.cell_data.at(0).values == soup.cell_data[0].values);
  CHECK(other.facet_data.at(0).name == "f");
  CHECK(other.edge_data.at(0).values == soup.edge_data[0].values);
  CHECK(Soup_bytes(other).bytes() == bytes);
  for(const std::size_t size : { std::size_t(0), bytes.size() / 2, bytes.size() - 1 })
    CHECK_THROWS_AS(Soup_bytes(bytes.substr(0, size)).restored(), VMP::Input_error);
}

TEST_CASE("Points of Nastran in a coordinate system of their own are refused")
{
  const Folder folder;
  const auto status = [&](const std::string& first_point)
  {
    folder.write("cell.bdf", "BEGIN BULK\n" + first_point
                 + "GRID    2               1.      0.      0.\nGRID    3       0       0.      1.      0.\n"
                   "GRID    4               0.      0.      1.\nCTETRA  1       1       1       2       3       4\nENDDATA\n");
    return folder.run("cell.bdf --improve");
  };
  const std::string free = "GRID    1               0.      0.      0.\n";
  if(fs::exists(PARAMETERIZE_MESH_FILE "_Gmsh.so"))
    CHECK(status(free) == 0);
  for(const std::string line : { "GRID    1       7       0.      0.      0.\n", "GRID,1,7,0.,0.,0.\n",
                                 "GRID*   1               7               0.              0.\n*       0.\n" })
  {
    CAPTURE(line);
    CHECK(status(line) == 2);
    CHECK(folder.text("stderr").find("cell.bdf: line 2: the coordinate system (CP) is '7'") == 0);
  }
  CHECK(status(free + "GRDSET          12\n") == 2);
  CHECK(folder.text("stderr").find("cell.bdf: line 3: the coordinate system (CP) is '12'") == 0);
}

TEST_CASE("Names of groups and data of the source are in the output, also where it is refined")
{
  const Folder folder;
  Soup source = fan_in_prism(12);
  source.group_names = { { { 3, 1 }, "bone" } };
  source.edges = { { 1, 2 } };
  source.edge_references = { 8 };
  source.point_data = { { "T", 1, false, {} }, { "x", 3, false, {} } };
  for(const Point& p : source.points)
  {
    source.point_data[0].values.push_back(p[0] + 2 * p[1] - p[2] / 3);
    source.point_data[1].values.insert(source.point_data[1].values.end(), p.begin(), p.end());
  }
  source.cell_data = { { "number", 1, true, {} } };
  for(std::size_t c = 0; c < source.cells.size(); ++c)
    source.cell_data[0].values.push_back(static_cast<double>(c));
  std::ofstream vtu(folder.path("source.vtu"), std::ios::binary);
  VMP::IO::write_VTU(vtu, source, source.points);
  vtu.close();
  Soup target = source;
  for(Point& p : target.points)
    p = {(1 + p[0]) * std::cos(p[2] / 4), p[1], (1 + p[0]) * std::sin(p[2] / 4)};
  folder.write("target.mesh", target);
  REQUIRE(folder.run("source.vtu target.mesh --refine -o map.vtu --refined-source refined.mesh") == 0);
  Soup map;
  VMP::IO::read_tetrahedron_soup(folder.path("map.vtu"), map);
  REQUIRE(map.points.size() > source.points.size());
  CHECK(map.group_names == source.group_names);
  CHECK(map.edge_references == std::vector<int>{ 8 });
  CHECK(folder.soup("refined.mesh").edges == source.edges);
  const auto data = [](const std::vector<VMP::Data_array_3>& arrays, const std::string& name)
  {
    const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const auto& array) { return array.name == name; });
    REQUIRE(found != arrays.end());
    return found->values;
  };
  const std::vector<double> T = data(map.point_data, "T"), x = data(map.point_data, "x"), numbers = data(map.cell_data, "number");
  REQUIRE(T.size() == map.points.size());
  REQUIRE(x.size() == 3 * map.points.size());
  for(std::size_t v = 0; v < map.points.size(); ++v)
  {
    const Point& p = map.points[v];
    CHECK(T[v] == Approx(p[0] + 2 * p[1] - p[2] / 3).margin(1e-12));
    CHECK(x[3 * v + 2] == p[2]);
  }
  REQUIRE(numbers.size() == map.cells.size());
  CHECK(numbers.size() > source.cells.size());
  CHECK(std::set<double>(numbers.begin(), numbers.end()).size() == source.cells.size());
}

TEST_CASE("The source may be a file of VTK, and so may the target")
{
  const Folder folder;
  Soup source = cube(2);
  source.cell_references[5] = 3;
  folder.write("source.mesh", source);
  folder.write("target.txt", boundary_lines(source, 2, affine));
  REQUIRE(folder.run("source.mesh target.txt -o map.vtu") == 0);
  REQUIRE(folder.run("source.mesh target.txt -o map.mesh") == 0);
  REQUIRE(folder.run("map.vtu target.txt -o other.mesh") == 0); // the points of this file are those of the source
  CHECK(folder.text("other.mesh") == folder.text("map.mesh"));
  REQUIRE(folder.run("source.mesh map.vtu -o same.mesh") == 0);
  CHECK(folder.soup("same.mesh").cell_references == source.cell_references);
}

namespace {

// Writes a file of VTK whose references have another name.
void write_regions(const Folder& folder, const std::string& file, const Soup& soup, const std::string& name)
{
  std::ostringstream os;
  VMP::IO::write_VTU(os, soup, soup.points);
  const std::string text = os.str(), reference = "\"reference\"";
  const std::size_t begin = text.find(reference);
  REQUIRE(begin != std::string::npos);
  folder.write(file, text.substr(0, begin) + "\"" + name + "\"" + text.substr(begin + reference.size()));
}

} // namespace

TEST_CASE("Regions have the names of many programs, or that of --regions; a note lists others")
{
  const Folder folder;
  Soup source = cube(2);
  for(std::size_t c = 0; c < source.cells.size(); ++c)
    source.cell_references[c] = c < 24 ? 7 : 8;
  const auto references = [&](const std::string& arguments)
  {
    CAPTURE(arguments);
    REQUIRE(folder.shell("\"$driver\" source.vtu --improve -o map.mesh " + arguments) == 0);
    return folder.soup("map.mesh").cell_references;
  };
  for(const char* name : { "medit:ref", "gmsh:physical", "material", "attribute", "mat_id", "MaterialIDs", "Material", "su2:tag",
                           "su2_tag", "cell_tags", "ModelRegionID", "RegionId", "CellEntityIds", "elemTag", "labels", "elset" })
  {
    write_regions(folder, "source.vtu", source, name);
    CHECK(references("") == source.cell_references);
    CHECK(folder.text("stderr") == "");
  }
  for(const std::string name : { "zone", "my zone", "it's 1" })
  {
    write_regions(folder, "source.vtu", source, name);
    CHECK(references("") == std::vector<int>(source.cells.size(), 0));
    const std::string note = folder.text("stderr"), advice = "--regions ";
    CHECK(note.find("note: source.vtu: the cell data '" + name + "' are integers with 2 values and are not used") == 0);
    const std::size_t begin = note.find(advice);
    REQUIRE(begin != std::string::npos);
    CHECK(references(note.substr(begin, note.find(" uses them") - begin)) == source.cell_references);
    CHECK(folder.text("stderr") == "");
  }
  // numbers of cells, and a copy of the references, are no other regions
  source.cell_data = { { "number", 1, true, {} }, { "copy", 1, true, {} } };
  for(std::size_t c = 0; c < source.cells.size(); ++c)
  {
    source.cell_data[0].values.push_back(static_cast<double>(c));
    source.cell_data[1].values.push_back(-source.cell_references[c]);
  }
  write_regions(folder, "source.vtu", source, "RegionId");
  CHECK(references("") == source.cell_references);
  CHECK(folder.text("stderr") == "");
  CHECK(folder.run("source.vtu --improve --regions none") == 2);
  CHECK(folder.text("stderr").find("source.vtu: there are no cell data 'none' for --regions; there are RegionId, ") == 0);

  // sets that meshio has joined
  source.cell_data.clear();
  for(std::size_t c = 0; c < source.cells.size(); ++c)
    source.cell_references[c] = c < 24 ? 0 : 2;
  write_regions(folder, "source.vtu", source, "BONE-FLESH-SKIN");
  REQUIRE(folder.run("source.vtu --improve -o map.vtu") == 0);
  CHECK(folder.text("stderr") == "note: source.vtu: the set 'FLESH' has no cell in the file, because meshio keeps only the last "
        "set of a cell. Remove larger sets before the conversion\n");
  Soup map;
  VMP::IO::read_tetrahedron_soup(folder.path("map.vtu"), map);
  using Group_names = std::map<std::pair<int, int>, std::string>;
  CHECK(map.group_names == Group_names{ { { 3, 1 }, "BONE" }, { { 3, 3 }, "SKIN" } });
  for(std::size_t c = 0; c < map.cells.size(); ++c)
    CHECK(map.cell_references[c] == (c < 24 ? 1 : 3));
}
