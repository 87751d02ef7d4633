// The program parameterize_mesh_file: limits of time, memory and files, and interruptions.
#include "driver.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <set>
#include <string>
#include <thread>

TEST_CASE("At the time limit, or interrupted, the valid map reached so far is written")
{
  const Folder folder;
  const Soup source = cube(20);
  folder.write("source.mesh", source);
  folder.write("target.txt", boundary_lines(source, 20, [](const Point& p)
  {
    const double c = std::cos(p[2] / 20), s = std::sin(p[2] / 20);
    return Point{c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
  }));
  const std::string command = "source.mesh target.txt --output map.mesh --report report.json";
  const auto check_files = [&](const std::string& reason)
  {
    CHECK(folder.names() == Names{"source.mesh", "target.txt", "map.mesh", "report.json"});
    const std::string report = folder.text("report.json");
    CHECK(report.find("\"status\": \"" + reason + " The map is valid") != std::string::npos);
    CHECK(report.find("\"status_code\": \"ERROR_INTERRUPTED\", \"has_valid_map\": true") != std::string::npos);
    CHECK(number(report, "inverted_cells") == 0);
    CHECK(folder.soup("map.mesh").cells == source.cells);
  };
  Terminal terminal(folder, command);
  CHECK(terminal.waits_for("reading source.mesh"));
  CHECK(terminal.waits_for("minimizing (minimization), step 1"));
  terminal.interrupt();
  CHECK(terminal.exit_code() == 0);
  check_files("Interrupted.");

  // There is no map before a time, and a complete one after another; between these, which depend on the machine, the limit
  // is to be found at which the map is valid only.
  double without_map = -1, complete = std::numeric_limits<double>::infinity();
  bool has_interrupted_map = false;
  for(double limit = 0; !has_interrupted_map;
      limit = std::isinf(complete) ? 2 * limit + 0.1 : (without_map + complete) / 2)
  {
    if(complete - without_map < 1e-3) // other programs took a part of the time: once more
    {
      without_map = 0;
      complete = std::numeric_limits<double>::infinity();
    }
    CAPTURE(limit);
    fs::remove(folder.path("map.mesh"));
    const int code = folder.run(command + " --time-limit " + std::to_string(limit));
    if(code == 3)
    {
      without_map = limit;
      CHECK(folder.text("stderr").find("The time limit was reached. There is no map ") == 0);
      CHECK(folder.names() == Names{"source.mesh", "target.txt", "report.json"});
      continue;
    }
    REQUIRE(code == 0);
    if(folder.text("stderr") == "")
    {
      complete = limit;
      continue;
    }
    has_interrupted_map = true;
    check_files("The time limit was reached.");
  }
  CHECK(without_map >= 0);
  CHECK(has_interrupted_map);
}

namespace {

// Returns the seconds that processors have spent on processes that have ended. Other programs on the machine leave them alone.
double seconds_of_processes()
{
  rusage usage;
  getrusage(RUSAGE_CHILDREN, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec)
    + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

} // namespace

TEST_CASE("An interruption, or the time limit, ends each part of the program")
{
  const Folder folder;
  const Soup source = cube(16);
  Soup bent = fan_in_prism(400), target = bent; // no map, and a search that goes on
  for(Point& p : target.points)
  {
    const double angle = 3.14159265358979 * p[2] / 400;
    p = {(100 + p[0]) * std::cos(angle), p[1], (100 + p[0]) * std::sin(angle)};
  }
  folder.write("source.mesh", source);
  folder.write("bent.mesh", bent);
  folder.write("target.mesh", target);
  struct Part
  {
    std::string arguments, text;
    std::set<int> exit_codes;
  };
  const auto check_files = [&](const int code)
  {
    CAPTURE(code, folder.text("report.json").substr(0, 300));
    CHECK(fs::exists(folder.path("map.mesh")) == (code < 2 || folder.text("report.json").find("The map is") != std::string::npos));
    CHECK(!fs::exists(folder.path("hexahedra.mesh")));
    CHECK((code == 0 || folder.text("report.json").find("\"ERROR_INTERRUPTED\"") != std::string::npos));
    fs::remove(folder.path("map.mesh"));
  };
  for(const Part& part : {
        Part{"source.mesh --to polycube", "mapping the boundary to polycube", {3}},
        Part{"source.mesh source.mesh", "numbering cells and vertices", {0, 1, 3}},
        Part{"bent.mesh target.mesh", "untangling", {1, 3}},
        Part{"bent.mesh target.mesh --refine", "untangling", {0, 1, 3}},
        Part{"source.mesh --to ball --refine", "minimizing", {0}},
        Part{"source.mesh source.mesh --hexahedra 0.25 hexahedra.mesh", "making hexahedra", {3}}})
  {
    CAPTURE(part.arguments, part.text);
    const std::string arguments = part.arguments + " -o map.mesh --report report.json";
    Terminal terminal(folder, arguments);
    REQUIRE(terminal.waits_for(part.text));
    terminal.interrupt();
    const int code = terminal.exit_code();
    CHECK(part.exit_codes.count(code) == 1);
    check_files(code);

    const double begin = seconds_of_processes();
    const int code_at_limit = folder.run(arguments + " --time-limit 0.5");
    CHECK(seconds_of_processes() - begin < 3); // two threads, and the end
    CHECK((code_at_limit == 0 || code_at_limit == 1 || code_at_limit == 3));
    if(code_at_limit != 0) // a fast machine may be ready
      check_files(code_at_limit);
    fs::remove(folder.path("map.mesh"));
    fs::remove(folder.path("hexahedra.mesh"));
  }
}

TEST_CASE("Who interrupts splits of a fitted boundary gets the map to the boundary so far")
{
  const Folder folder;
  folder.write("source.mesh", cube(2));
  folder.write("octahedron.off", "OFF\n6 8 0\n3 0 0\n-3 0 0\n0 2 0\n0 -2 0\n0 0 2\n0 0 -2\n3 0 2 4\n3 2 1 4\n3 1 3 4\n"
                                 "3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n");
  Terminal terminal(folder, "source.mesh --to octahedron.off --tolerance 1e-9 -o map.mesh");
  REQUIRE(terminal.waits_for("(splits of a fitted boundary), round"));
  terminal.interrupt();
  CHECK(terminal.waits_for("Interrupted. The map is valid, but may be farther from its target than --tolerance"));
  CHECK(terminal.exit_code() == 0);
  CHECK(folder.soup("map.mesh").points.size() >= cube(2).points.size());
}

TEST_CASE("The line on a terminal moves with the boundary and with hexahedra")
{
  const Folder folder;
  folder.write("source.mesh", cube(4));
  Terminal terminal(folder, "source.mesh --to polycube --refine=none --hexahedra 1 hexahedra.mesh --report report.json");
  CHECK(terminal.waits_for("mapping the boundary ("));
  CHECK(terminal.waits_for("), round 2"));
  CHECK(terminal.waits_for("making hexahedra (corners), round 1"));
  CHECK(terminal.exit_code() == 0);
  const std::string report = folder.text("report.json"); // whose steps are those of the map
  const std::size_t begin = report.find("\"steps\": {\"energy\": [");
  const std::string energies = report.substr(begin, report.find(']', begin) - begin);
  CHECK(1 + std::count(energies.begin(), energies.end(), ',') == number(report, "iterations"));
}

TEST_CASE("An interruption ends the program while it reads, too")
{
  const Folder folder;
  REQUIRE(mkfifo(folder.path("source.mesh").c_str(), 0600) == 0); // nobody writes
  Terminal terminal(folder, "source.mesh --to ball -o map.vtu --report report.json");
  CHECK(terminal.waits_for("reading source.mesh"));
  usleep(100000);
  terminal.interrupt();
  CHECK(terminal.waits_for("Interrupted. There is no map yet."));
  CHECK(terminal.exit_code() == 3);
  CHECK(folder.names() == Names{"source.mesh", "report.json"});
}

TEST_CASE("The second interruption leaves no unfinished file")
{
  const Folder folder;
  folder.write("source.mesh", cube(20));
  Terminal terminal(folder, "source.mesh source.mesh -o map.mesh");
  CHECK(terminal.waits_for("writing"));
  while(folder.names().size() == 1)
    usleep(100);
  terminal.interrupt_and_terminate();
  terminal.exit_code();
  for(const std::string& name : folder.names())
    CHECK(fs::path(name).extension() == ".mesh");
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("There are no more threads than processors, which is told")
{
  const Folder folder;
  folder.write("source.mesh", cube(2));
  const std::string processors = std::to_string(std::thread::hardware_concurrency());
  REQUIRE(folder.run("source.mesh --to polycube --refine=none --threads 2147483647 --report report.json") == 0);
  CHECK(folder.text("stderr").find("note: " + processors + " threads run instead of 2147483647, ") == 0);
  CHECK(folder.text("report.json").find("\"threads\": " + processors + ",") != std::string::npos);
}
#endif

TEST_CASE("A limit of the size of files ends in a sentence, and leaves nothing")
{
  const Folder folder;
  folder.write("source.mesh", cube(3));
  CHECK(folder.shell("ulimit -f 4; \"$driver\" source.mesh source.mesh -o map.mesh") == 2);
  CHECK(folder.text("stderr").find("map.mesh: the file cannot be written completely: File too large") != std::string::npos);
  CHECK(folder.names() == Names{"source.mesh"});
}

TEST_CASE("A terminal that is closed ends the program as an interruption does")
{
  const Folder folder;
  folder.write("source.mesh", cube(20));
  Soup target = cube(20);
  for(Point& p : target.points)
    p = { p[0] + 0.1 * p[1] * p[2] / 20, p[1], p[2] };
  folder.write("target.mesh", target);
  Terminal terminal(folder, "source.mesh target.mesh -o map.mesh");
  CHECK(terminal.waits_for("minimizing (minimization), step 1"));
  terminal.send(SIGHUP);
  CHECK(terminal.exit_code() == 0);
  CHECK(folder.names() == Names{"source.mesh", "target.mesh", "map.mesh"});
}

TEST_CASE("A pipe that nobody reads is given up at the time limit, and when interrupted")
{
  const Folder folder;
  folder.write("source.mesh", cube(1));
  REQUIRE(mkfifo(folder.path("pipe").c_str(), 0600) == 0);
  CHECK(folder.shell("timeout 600 \"$driver\" source.mesh source.mesh -o pipe --time-limit 0.5 --report report.json") == 3);
  CHECK(folder.text("stderr")
        == "No file is written. The time limit was reached. pipe: nobody reads this\n");
  CHECK(folder.text("report.json").find("\"ERROR_INTERRUPTED\", \"has_valid_map\": true") != std::string::npos);
  CHECK(folder.shell("timeout 600 \"$driver\" source.mesh none.mesh --time-limit 0.5 --report pipe") == 3);

  Terminal terminal(folder, "source.mesh source.mesh -o pipe");
  CHECK(terminal.waits_for("writing"));
  terminal.interrupt();
  CHECK(terminal.waits_for("Interrupted. pipe: nobody reads this"));
  CHECK(terminal.exit_code() == 3);

  // a reader that comes late gets all
  CHECK(folder.shell("{ sleep 0.5; cat pipe; } > copy.mesh & \"$driver\" source.mesh source.mesh -o pipe; wait") == 0);
  CHECK(folder.soup("copy.mesh").cells == cube(1).cells);
}

TEST_CASE("Where memory is limited, there is a map or a sentence")
{
  const Folder folder;
  folder.write("source.mesh", cube(6));
  std::set<int> codes;
  for(int kilobytes = 20000, steps = 0; codes.count(0) == 0 && steps < 200; kilobytes += 1000, ++steps)
  {
    const auto driver_with = [](const int limit) { return "ulimit -v " + std::to_string(limit) + "; \"$driver\" "; };
    // Libraries cannot be loaded, or at some addresses only. With too little memory, initializers of libgfortran call each other
    // until the stack ends, before the program begins.
    if(folder.shell(driver_with(kilobytes - 2000) + "--version") != 0)
      continue;
    const int code = folder.shell(driver_with(kilobytes) + "source.mesh source.mesh -o map.mesh");
    CAPTURE(kilobytes, folder.text("stderr"));
    CHECK((code == 0 || code == 3));
    CHECK((code == 0 || folder.text("stderr") != ""));
    codes.insert(code);
  }
  CHECK(codes == std::set<int>{0, 3});
}
