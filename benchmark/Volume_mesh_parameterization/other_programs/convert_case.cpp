// Converts a case of public sets for other programs, and the positions that a program has found to a mesh.
//
//   convert_case begin SOURCE TARGET FOLDER   writes rest.mesh, start.mesh, targets.txt, source.vtk, start.vtk, input (of TLC)
//   convert_case end FOLDER RESULT OUTPUT     writes the mesh of RESULT, a file of TLC, MEDIT or VTK
//   convert_case copy FOLDER RESULT OUTPUT    writes the mesh of VTK as it is, but for the order of vertices
//
// The rest shape is the source, scaled to the volume of the start. The start is harmonic with the weight 1 for all edges.
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT_format.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/boundary_vertices.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

using Targets = std::vector<std::pair<std::size_t, std::array<double, 3> > >;

static std::ofstream open(const std::string& filename)
{
  std::ofstream file(filename);
  file.precision(17);
  if(!file)
    throw std::runtime_error(filename + ": this file cannot be written");
  return file;
}

static VMP::Tetrahedron_soup_3 read_mesh(const std::string& filename)
{
  VMP::Tetrahedron_soup_3 soup;
  if(!VMP::IO::read_MEDIT(filename, soup))
    throw std::runtime_error(filename + ": this file cannot be read");
  return soup;
}

static Targets read_targets(const std::string& filename)
{
  std::ifstream file(filename);
  Targets targets;
  std::pair<std::size_t, std::array<double, 3> > t;
  for(std::string line; std::getline(file, line); ) // others are comments
    if(std::istringstream in(line); in >> t.first >> t.second[0] >> t.second[1] >> t.second[2])
      targets.push_back(t);
  return targets;
}

static Targets targets_of(const std::string& filename, const VMP::Tetrahedron_soup_3& source)
{
  if(filename.substr(filename.find_last_of('.')) == ".txt")
    return read_targets(filename);
  const VMP::Tetrahedron_soup_3 target = read_mesh(filename); // of the same connectivity
  Targets targets;
  for(const std::size_t v : VMP::boundary_vertices(source.points, source.cells))
    targets.emplace_back(v, target.points[v]);
  return targets;
}

// Puts each vertex without a target at the mean of its neighbors, each once for each cell of their edge.
static std::vector<std::array<double, 3> > harmonic_positions(const VMP::Tetrahedron_soup_3& source, const Targets& targets)
{
  using Matrix = Eigen::SparseMatrix<double>;
  std::vector<std::array<double, 3> > result = source.points;
  std::vector<Eigen::Index> number(source.points.size(), 0);
  for(const auto& [v, p] : targets)
  {
    number[v] = -1;
    result[v] = p;
  }
  Eigen::Index n = 0;
  for(Eigen::Index& i : number)
    i = i < 0 ? i : n++;
  std::vector<Eigen::Triplet<double> > entries;
  Eigen::MatrixX3d b = Eigen::MatrixX3d::Zero(n, 3), x(n, 3);
  for(const auto& cell : source.cells)
    for(const std::size_t v : cell)
      for(const std::size_t w : cell)
        if(v != w && number[v] >= 0)
        {
          entries.emplace_back(number[v], number[v], 1);
          if(number[w] >= 0)
            entries.emplace_back(number[v], number[w], -1);
          else
            b.row(number[v]) += Eigen::RowVector3d::Map(result[w].data());
        }
  Matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> solver(matrix);
  solver.setTolerance(1e-10);
  x = solver.solve(b);
  for(std::size_t v = 0; v < result.size(); ++v)
    if(number[v] >= 0)
      Eigen::RowVector3d::Map(result[v].data()) = x.row(number[v]);
  return result;
}

static double volume(const VMP::Tetrahedron_soup_3& soup)
{
  const auto p = [&](const std::size_t v) { return Eigen::Vector3d::Map(soup.points[v].data()); };
  double result = 0;
  for(const auto& c : soup.cells)
    result += (p(c[1]) - p(c[0])).cross(p(c[2]) - p(c[0])).dot(p(c[3]) - p(c[0])) / 6;
  return result;
}

static void write_VTK(const std::string& filename, const VMP::Tetrahedron_soup_3& soup)
{
  std::ofstream file = open(filename);
  file << "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " << soup.points.size() << " double\n";
  for(const auto& p : soup.points)
    file << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  file << "CELLS " << soup.cells.size() << ' ' << 5 * soup.cells.size() << '\n';
  for(const auto& c : soup.cells)
    file << "4 " << c[0] << ' ' << c[1] << ' ' << c[2] << ' ' << c[3] << '\n';
  file << "CELL_TYPES " << soup.cells.size() << '\n';
  for(std::size_t t = 0; t < soup.cells.size(); ++t)
    file << "10\n";
}

static VMP::Tetrahedron_soup_3 read_VTK(const std::string& filename)
{
  VMP::Tetrahedron_soup_3 soup;
  std::ifstream file(filename);
  std::size_t n;
  for(std::string word; file >> word; )
    if(word == "POINTS" && file >> n >> word)
    {
      soup.points.resize(n);
      for(auto& p : soup.points)
        file >> p[0] >> p[1] >> p[2];
    }
    else if(word == "CELLS" && file >> n >> word)
    {
      soup.cells.resize(n);
      for(auto& c : soup.cells)
        file >> word >> c[0] >> c[1] >> c[2] >> c[3];
    }
  if(soup.cells.empty())
    throw std::runtime_error(filename + ": this file cannot be read");
  soup.cell_references.assign(soup.cells.size(), 0);
  return soup;
}

// Reads a mesh of a program that splits cells. The vertices of the source come first, as before: the program may reorder them. Its
// refined source result_object.vtk, which has their coordinates, tells the order.
static VMP::Tetrahedron_soup_3 read_refined(const std::string& folder, const std::string& filename)
{
  VMP::Tetrahedron_soup_3 soup = read_VTK(filename);
  std::map<std::array<double, 3>, std::size_t> number_of_point;
  for(const auto& p : read_VTK(folder + "/source.vtk").points)
    number_of_point.emplace(p, number_of_point.size());
  std::size_t n = number_of_point.size();
  std::vector<std::size_t> numbers;
  for(const auto& p : read_VTK(folder + "/result_object.vtk").points)
  {
    const auto it = number_of_point.find(p);
    numbers.push_back(it == number_of_point.end() ? n++ : it->second);
  }
  std::vector<std::array<double, 3> > points(n);
  for(std::size_t v = 0; v < numbers.size(); ++v)
    points.at(numbers[v]) = soup.points.at(v);
  soup.points = std::move(points);
  for(auto& cell : soup.cells)
    for(std::size_t& v : cell)
      v = numbers[v];
  return soup;
}

static void write_input_of_TLC(const std::string& filename, const VMP::Tetrahedron_soup_3& rest,
                               const VMP::Tetrahedron_soup_3& start, const Targets& targets)
{
  std::ofstream file = open(filename);
  for(const auto* soup : { &rest, &start })
  {
    file << soup->points.size() << " 3\n";
    for(const auto& p : soup->points)
      file << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  }
  file << rest.cells.size() << " 4\n";
  for(const auto& c : rest.cells)
    file << c[0] << ' ' << c[1] << ' ' << c[2] << ' ' << c[3] << '\n';
  file << targets.size() << '\n';
  for(const auto& target : targets)
    file << target.first << '\n';
}

static void begin(const std::string& source, const std::string& target, const std::string& folder)
{
  VMP::Tetrahedron_soup_3 rest = read_mesh(source), start = rest;
  const Targets targets = targets_of(target, rest);
  start.points = harmonic_positions(rest, targets);
  write_VTK(folder + "/source.vtk", rest);
  write_VTK(folder + "/start.vtk", start);
  const double scale = std::cbrt(std::abs(volume(start) / volume(rest)));
  for(auto& p : rest.points)
    for(double& x : p)
      x *= scale;
  VMP::IO::write_MEDIT(folder + "/rest.mesh", rest);
  VMP::IO::write_MEDIT(folder + "/start.mesh", start);
  write_input_of_TLC(folder + "/input", rest, start, targets);
  std::ofstream file = open(folder + "/targets.txt");
  for(const auto& [v, p] : targets)
    file << v << ' ' << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
}

static std::vector<std::array<double, 3> > positions_of_TLC(const std::string& filename)
{
  std::ifstream file(filename);
  std::string name;
  std::size_t n = 0;
  file >> name >> n >> name;
  std::vector<std::array<double, 3> > result(n);
  for(auto& p : result)
    file >> p[0] >> p[1] >> p[2];
  return result;
}

// Undoes the scaling of programs. Vertices that have met their targets up to rounding get these.
static void end(const std::string& folder, const std::string& result, const std::string& output)
{
  const std::string suffix = result.substr(result.find_last_of("/."));
  VMP::Tetrahedron_soup_3 soup = suffix == ".vtk" ? read_refined(folder, result) : read_mesh(folder + "/start.mesh");
  if(suffix != ".vtk")
    soup.points = suffix == ".mesh" ? read_mesh(result).points : positions_of_TLC(result);
  const Targets targets = read_targets(folder + "/targets.txt");
  Eigen::AlignedBox3d box, box_of_targets;
  for(const auto& [v, p] : targets)
  {
    box.extend(Eigen::Vector3d(Eigen::Vector3d::Map(soup.points.at(v).data())));
    box_of_targets.extend(Eigen::Vector3d(Eigen::Vector3d::Map(p.data())));
  }
  const double extent = box_of_targets.diagonal().norm(), scale = extent / box.diagonal().norm();
  for(auto& p : soup.points)
    for(double& x : p)
      x *= scale;
  for(const auto& [v, p] : targets)
    if((Eigen::Vector3d::Map(p.data()) - Eigen::Vector3d::Map(soup.points[v].data())).norm() < 1e-6 * extent)
      soup.points[v] = p;
  VMP::IO::write_MEDIT(output, soup);
}

int main(int argc, char** argv)
{
  if(argc != 5)
    return EXIT_FAILURE;
  if(argv[1] == std::string("copy"))
    VMP::IO::write_MEDIT(argv[4], read_refined(argv[2], argv[3]));
  else
    (argv[1] == std::string("begin") ? begin : end)(argv[2], argv[3], argv[4]);
  return EXIT_SUCCESS;
}
