// The program parameterize_mesh_file: its options, its help, and the commands that it advises.
#include "driver.h"

#include <cstddef>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>

TEST_CASE("A faulty command line: exit code 2 and nothing is touched")
{
  const Folder folder;
  const Soup source = cube(2);
  folder.write("source.mesh", source);
  folder.write("target.txt", boundary_lines(source, 2, affine));
  const std::string mesh = folder.text("source.mesh");
  const std::string target = folder.text("target.txt");

  for(const std::string arguments : {
        "", "source.mesh", "source.mesh target.txt third", "source.mesh target.txt --unknown",
        "source.mesh target.txt --energy none", "source.mesh target.txt --solver none",
        "source.mesh target.txt --threads 0", "source.mesh target.txt --threads x",
        "source.mesh target.txt --max-iterations -1", "source.mesh target.txt --output map.obj",
        "source.mesh target.txt --max-angle-distortion 2", "source.mesh target.txt --energy-tolerance -1",
        "source.mesh target.txt --max-angle-distortion 3 --minimize-max-angle-distortion",
        "source.mesh target.txt --time-limit -1",
        "source.mesh target.txt --to ball", "source.mesh --to", "source.mesh --to none", "source.mesh --to box=1,2",
        "source.mesh --to box=1,2,0", "source.mesh --to box=1,2,3,4", "source.mesh --to box=1:2:3",
        "source.mesh target.txt --output map",
        "source.mesh target.txt --output no/folder/map.mesh", "source.mesh target.txt --report .",
        "- - < source.mesh", "source.mesh target.txt --output - --report -",
        "source.mesh target.txt --output ./source.mesh", "source.mesh target.txt --report target.txt",
        "source.mesh target.txt --output map.mesh --report ./map.mesh"})
  {
    CAPTURE(arguments);
    CHECK(folder.run(arguments) == 2);
    CHECK(folder.text("stderr") != "");
    CHECK(folder.names() == Names{"source.mesh", "target.txt"});
    CHECK(folder.text("source.mesh") == mesh);
    CHECK(folder.text("target.txt") == target);
  }
  const auto alternatives = [&folder](const std::string& arguments)
  {
    folder.run("source.mesh " + arguments);
    const std::string text = folder.text("stderr");
    const std::size_t colon = text.find("; choose among: ");
    return colon == std::string::npos ? text : text.substr(colon + 16);
  };
  CHECK(alternatives("target.txt --energy none") == "stretch, symmetric_dirichlet, mips, arap, dirichlet, lscm, lpm\n");
  CHECK(alternatives("target.txt --solver none").find("cg") == 0);
  CHECK(alternatives("target.txt --boundary none") == "auto, fixed, soft\n");
  CHECK(alternatives("--to polycube --polycube-axes none") == "found, given\n");
  CHECK(alternatives("--to none") == "ball, cube, box=X,Y,Z, polycube, a surface *.off, *.stl, *.obj, *.ply or *.vtp\n");
  // each of them can be chosen; domains are in a test of their own
  for(const std::string option : {"--energy", "--solver", "--boundary", "--refine", "--others"})
  {
    std::istringstream names(alternatives("target.txt " + option + "=NONE"));
    for(std::string name; names >> name;)
      CHECK(folder.run("source.mesh target.txt " + option + "=" + name.substr(0, name.find(','))) == 0);
  }
  CHECK(folder.run("source.mesh --to box=1,2") == 2);
  std::smatch example;
  const std::string advice = folder.text("stderr");
  REQUIRE(std::regex_search(advice, example, std::regex("such as (box=.*)")));
  CHECK(folder.run("source.mesh --refine --to " + example.str(1)) == 0);

  CHECK(folder.run("--version") == 0);
  CHECK(std::regex_match(folder.text("stdout"), std::regex("parameterize_mesh_file [0-9.]+ \\(CGAL .*\\)\n"
                                                         "meshes that it reads: .mesh .meshb .vtu.*\n"
                                                         "bodies that it fills: .*\nmeshes that it writes: .mesh.*\n")));
  CHECK((folder.text("stdout").find(".step") != std::string::npos) == fs::exists(PARAMETERIZE_MESH_FILE "_Gmsh.so"));
  CHECK(folder.run("--help") == 0);
  for(const std::string part : {"Usage:", "SOURCE.mesh", "TARGET", "--output ] FILE", "--to DOMAIN", "--max-iterations N",
                                "Exit status:"})
    CHECK(folder.text("stdout").find(part) != std::string::npos);
}

TEST_CASE("The examples of the help run as they are written")
{
  const Folder folder;
  const fs::path data = fs::path(PARAMETERIZE_MESH_FILE).parent_path() / "data";
  for(const char* name : {"cube.mesh", "cube_to_ball.txt"})
    fs::copy(data / name, folder.path(name));
  REQUIRE(folder.run("--help") == 0);
  std::istringstream help(folder.text("stdout"));
  CHECK(folder.text("stdout").find("Examples:\n") == 0);
  int number_of_examples = 0;
  const std::string part = "part.step";
  Names files = {"cube.mesh", "cube_to_ball.txt", "ball.vtu", "ball.mesh", "source.mesh"};
  const std::string program = "  parameterize_mesh_file ";
  for(std::string line; std::getline(help, line);)
    if(line.find(program) == 0)
    {
      CAPTURE(line);
      ++number_of_examples;
      if(const std::size_t begin = line.find(part); begin != std::string::npos)
      {
        if(!fs::exists(PARAMETERIZE_MESH_FILE "_Gmsh.so"))
          continue;
        folder.write("part.geo", "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 4, 4, 6};\n");
        line.replace(begin, part.size(), "part.geo"); // another format of a body, which takes a line
        files.insert({ "part.geo", "part.inp" });
      }
      CHECK(folder.run(line.substr(program.size())) == 0);
    }
  CHECK(number_of_examples == 3);
  CHECK(folder.names() == files);
  CHECK(folder.text("ball.vtu").find("Name=\"uvw\"") != std::string::npos);
  for(const char* name : {"angle_distortion", "volume_distortion"})
    CHECK(folder.text("ball.vtu").find(name) != std::string::npos);
  CHECK(folder.soup("ball.mesh").cells == folder.soup("source.mesh").cells);
}

TEST_CASE("Vertices that slide are advised by the name of their option, which helps")
{
  const Folder folder;
  const Soup source = cube(3);
  folder.write("source.mesh", source);
  folder.write("target.txt", boundary_lines(source, 3, [](const Point& p)
  {
    return p == Point{1, 1, 0} ? Point{1.99, 1.997, 0} : p; // two facets are nearly flat
  }));
  CHECK(folder.run("source.mesh target.txt") == 0);
  CHECK(folder.text("stderr").find("or vertices that slide (--slide), would help") != std::string::npos);
  CHECK(folder.run("source.mesh target.txt --slide") == 0);
  CHECK(folder.text("stderr") == "");
}

TEST_CASE("Options that exclude each other, change nothing or cannot succeed are named")
{
  const Folder folder;
  folder.write("source.mesh", cube(2));
  folder.write("empty.txt", "# nothing\n");
  const auto prints = [&](const std::string& text) { return folder.text("stderr").find(text) != std::string::npos; };
  CHECK(folder.run("source.mesh --improve --to ball") == 2);
  CHECK(prints("--improve excludes TARGET and --to"));
  CHECK(folder.run("source.mesh --conditions empty.txt") == 0);
  CHECK(prints("note: empty.txt: no line changes the condition of a vertex\n"));
  CHECK(folder.run("source.mesh --to polycube --hexahedra 0.001 hexahedra.mesh -o map.mesh") == 2);
  CHECK(prints("source.mesh: with a spacing of 0.001, there would be about 8e+09 hexahedra"));
  CHECK(folder.names() == Names{"source.mesh", "empty.txt"});
  CHECK(folder.run("source.mesh --to ball -o /dev/full") == 2);
  CHECK(folder.text("stdout").find("-o FILE") == std::string::npos);
}

TEST_CASE("Advised commands have file names as a shell wants them")
{
  const Folder folder;
  fs::create_directory(folder.path("it's here"));
  folder.write("it's here/a b.med", "v 0 0 0\n");
  CHECK(folder.run("\"it's here/a b.med\" --to ball") == 2);
  const std::string sentence = folder.text("stderr"), command = "meshio convert ";
  const std::size_t begin = sentence.find(command);
  REQUIRE(begin != std::string::npos);
  REQUIRE(folder.shell("printf '%s\\n' " + sentence.substr(begin + command.size())) == 0);
  CHECK(folder.text("stdout") == "it's here/a b.med\nit's here/a b.vtu\n");
}
