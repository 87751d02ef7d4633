// The program parameterize_mesh_file: streams, links and modes of files.
#include "driver.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>

TEST_CASE("Each file may be a pipe, and - is the standard input or output")
{
  const Folder folder;
  const Soup source = cube(2);
  folder.write("source.mesh", source);
  folder.write("target.txt", boundary_lines(source, 2, affine));
  REQUIRE(folder.run("source.mesh target.txt -o map.mesh") == 0);
  const std::string map = folder.text("map.mesh"), summary = folder.text("stdout");

  for(const std::string input : { "-", "/dev/stdin", "/dev/fd/0" })
  {
    CHECK(folder.run(input + " target.txt -o copy.mesh < source.mesh") == 0);
    CHECK(folder.text("copy.mesh") == map);
    CHECK(folder.run("source.mesh " + input + " -o copy.mesh < target.txt") == 0);
    CHECK(folder.text("copy.mesh") == map);
  }
  for(const std::string output : { "-", "/dev/stdout" })
  {
    CHECK(folder.run("source.mesh target.txt -o " + output) == 0);
    CHECK(folder.text("stdout") == map);
    CHECK(folder.text("stderr").find("distortion of angles") != std::string::npos);
    CHECK(folder.run("source.mesh target.txt -o copy.mesh --report " + output) == 0);
    CHECK(keys(folder.text("stdout")) == report_keys);
  }
  CHECK(folder.run("source.mesh target.txt --report /dev/null") == 0);
  CHECK(folder.text("stdout").substr(0, 20) == summary.substr(0, 20));

  for(const std::string name : { "in", "out", "report" })
    REQUIRE(mkfifo(folder.path(name).c_str(), 0600) == 0);
  CHECK(folder.shell("cat source.mesh > in & cat out > copy.mesh & cat report > report.json & "
                     "\"$driver\" in target.txt --quiet -o out --report report && wait")
        == 0);
  CHECK(folder.text("copy.mesh") == map);
  CHECK(keys(folder.text("report.json")) == report_keys);
  CHECK(fs::is_fifo(folder.path("out")));

  // nothing is written of what fails
  CHECK(folder.run("source.mesh none.txt -o -") == 2);
  CHECK(folder.text("stdout") == "");
  CHECK(folder.run("source.mesh target.txt -o /dev/full") == 2);
  CHECK(folder.text("stderr").find("/dev/full: this cannot be written completely") != std::string::npos);
}

TEST_CASE("An output behind symbolic links is written where they lead, and the links stay")
{
  const Folder folder;
  const Soup source = cube(1);
  folder.write("source.mesh", source);
  folder.write("target.txt", boundary_lines(source, 1, affine));
  fs::create_directory(folder.path("there"));
  fs::create_symlink("there/map.mesh", folder.path("second.mesh")); // nothing is there yet
  fs::create_symlink("second.mesh", folder.path("first.mesh"));
  for(int run = 0; run < 2; ++run)
  {
    CHECK(folder.run("source.mesh target.txt -o first.mesh") == 0);
    CHECK(fs::is_symlink(folder.path("first.mesh")));
    CHECK(fs::is_symlink(folder.path("second.mesh")));
    CHECK(fs::is_regular_file(fs::symlink_status(folder.path("there/map.mesh"))));
    CHECK(folder.soup("first.mesh").cells == source.cells);
  }
  fs::create_symlink("nowhere/map.mesh", folder.path("lost.mesh"));
  fs::create_symlink("ring.mesh", folder.path("ring.mesh"));
  fs::create_symlink("twin.mesh", folder.path("report.json"));
  for(const std::string names : {"lost.mesh", "ring.mesh", "twin.mesh --report report.json"})
  {
    CAPTURE(names);
    CHECK(folder.run("source.mesh target.txt -o " + names) == 2);
    CHECK(folder.text("stderr") != "");
  }
  CHECK(fs::is_symlink(folder.path("lost.mesh")));
  CHECK(fs::is_symlink(folder.path("report.json")));
}

TEST_CASE("The report never replaces what is not a regular file")
{
  const Folder folder;
  const Soup source = cube(1);
  folder.write("source.mesh", source);
  folder.write("target.txt", boundary_lines(source, 1, affine));
  fs::create_directory(folder.path("report.json"));
  CHECK(folder.run("source.mesh target.txt --report report.json") == 2);
  CHECK(fs::is_directory(folder.path("report.json")));
}

TEST_CASE("A link in the place of a temporary file leads nowhere")
{
  const Folder folder;
  const Soup source = cube(1);
  folder.write("source.mesh", source);
  folder.write("other.txt", "of somebody else");
  CHECK(folder.shell("sh -c 'ln -s other.txt map.mesh.$$.tmp && exec \"$0\" source.mesh source.mesh -o map.mesh' \"$driver\"")
        == 0);
  CHECK(folder.text("other.txt") == "of somebody else");
  CHECK(folder.soup("map.mesh").cells == source.cells);
}

TEST_CASE("An output keeps the mode of the file that it replaces, and may have the longest name")
{
  const Folder folder;
  const std::string name = std::string(250, 'm') + ".mesh";
  folder.write("source.mesh", cube(1));
  const auto mode = [&] { return static_cast<unsigned>(fs::status(folder.path(name)).permissions()); };
  CHECK(folder.shell("umask 027; \"$driver\" source.mesh source.mesh -o " + name) == 0);
  CHECK(mode() == 0640);
  fs::permissions(folder.path(name), static_cast<fs::perms>(0602));
  CHECK(folder.shell("umask 027; \"$driver\" source.mesh source.mesh -o " + name) == 0);
  CHECK(mode() == 0602);
  CHECK(folder.run("source.mesh source.mesh -o m" + name) == 2);
  CHECK(folder.text("stderr").find("the file cannot be written: File name too long") != std::string::npos);
}

TEST_CASE("A file that cannot be written after the map is told with the map")
{
  const Folder folder;
  folder.write("source.mesh", cube(2));
  for(const std::string arguments : { "--refined-source /dev/full", "--hexahedra 1 /dev/full" })
  {
    CAPTURE(arguments);
    CHECK(folder.run("source.mesh source.mesh --report report.json -o map.mesh " + arguments) == 2);
    CHECK(folder.text("stderr") == "The map is complete in map.mesh. /dev/full: this cannot be written completely: "
                                   "No space left on device\n");
    CHECK(folder.soup("map.mesh").cells == cube(2).cells);
    const std::string report = folder.text("report.json");
    CHECK(report.find("\"status_code\": \"ERROR_FILE_NOT_WRITTEN\", \"has_valid_map\": true") != std::string::npos);
    CHECK(number(report, "cells") == 48);
    fs::remove(folder.path("map.mesh"));
  }
}

TEST_CASE("What is printed to a full device is an error")
{
  const Folder folder;
  folder.write("source.mesh", cube(1));
  for(const std::string arguments : { "--help", "--version", "source.mesh source.mesh" })
  {
    CHECK(folder.run(arguments + " > /dev/full") == 2);
    CHECK(folder.text("stderr") == "the standard output cannot be written\n");
  }
  CHECK(folder.run("source.mesh source.mesh --quiet > /dev/full") == 0);
}

TEST_CASE("A stream has one role, whatever its names are")
{
  const Folder folder;
  folder.write("source.mesh", cube(1));
  REQUIRE(mkfifo(folder.path("pipe").c_str(), 0600) == 0);
  fs::create_symlink("pipe", folder.path("other"));
  for(const std::string arguments : {
        "source.mesh source.mesh -o /dev/stdout --report /dev/fd/1", "source.mesh source.mesh -o - --report /proc/self/fd/1",
        "source.mesh source.mesh -o pipe --report other", "source.mesh source.mesh -o map.mesh --report - > map.mesh"})
  {
    CAPTURE(arguments);
    CHECK(folder.run(arguments) == 2);
    CHECK(folder.text("stderr").find("this file has two roles") != std::string::npos);
  }
  CHECK(folder.run("- /dev/fd/0 < source.mesh") == 2);
  CHECK(folder.text("stderr").find("this input has two roles") != std::string::npos);
  CHECK(folder.run("source.mesh source.mesh -o /dev/null --report /dev/null") == 0);
}

TEST_CASE("The standard input is read from where it stands, and may be a socket")
{
  const Folder folder;
  folder.write("source.mesh", cube(2));
  folder.write("source.txt", "a line of somebody else\n" + folder.text("source.mesh"));
  CHECK(folder.shell("{ read line; \"$driver\" - source.mesh -o map.mesh; } < source.txt") == 0);
  CHECK(folder.soup("map.mesh").cells == cube(2).cells);

  int sockets[2];
  REQUIRE(socketpair(AF_UNIX, SOCK_STREAM, 0, sockets) == 0);
  const pid_t process = fork();
  if(process == 0)
  {
    dup2(sockets[1], 0);
    dup2(sockets[1], 1);
    close(sockets[0]);
    execl(PARAMETERIZE_MESH_FILE, "driver", "-", folder.path("source.mesh").c_str(), "--quiet", "-o", "-",
          static_cast<char*>(nullptr));
    _exit(127);
  }
  close(sockets[1]);
  const std::string mesh = folder.text("source.mesh");
  CHECK(write(sockets[0], mesh.data(), mesh.size()) == static_cast<ssize_t>(mesh.size()));
  shutdown(sockets[0], SHUT_WR);
  std::string map;
  for(char c; read(sockets[0], &c, 1) == 1;)
    map += c;
  close(sockets[0]);
  int status = -1;
  waitpid(process, &status, 0);
  CHECK(status == 0);
  CHECK(map == folder.text("map.mesh"));
}

TEST_CASE("The report is UTF-8, whatever the names of files are")
{
  const Folder folder;
  const std::string good = "K\xC3\xB6rper.mesh", bad = "K\xF6rper\xED\xA0\x80.mesh";
  folder.write(good, cube(1));
  folder.write(bad, cube(1));
  REQUIRE(folder.run("'" + good + "' '" + bad + "' --report report.json") == 0);
  CHECK(folder.text("report.json").find("\"source\": \"" + good + "\"") != std::string::npos);
  CHECK(folder.text("report.json").find("\"target\": \"K\\ufffdrper\\ufffd\\ufffd\\ufffd.mesh\"") != std::string::npos);
}
