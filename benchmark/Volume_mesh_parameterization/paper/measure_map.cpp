// Judges a map, whoever computed it:
//   measure_map SOURCE.mesh TARGET MAP.mesh NAME
// Writes NAME.json, and NAME.vtu with the map and its distortions by cells. The distortions are those of the
// map scaled to the volume of the source; inverted cells are counted, and left out of the distortions.
#include "../../../examples/Volume_mesh_parameterization/parameterize_mesh_file/JSON_object.h"
#include "Map_problem.h"

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/internal/Energies/Cell_arithmetic_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/Numbered_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/measure_distortion_3.h>

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

namespace VMP = CGAL::Volume_mesh_parameterization;

std::string measure(const Map_problem::Mesh& mesh, const Eigen::Matrix3Xd& image)
{
  VMP::Distortion_3 distortion = {0, 0, 0, 0};
  std::size_t number_of_inverted_cells = 0;
  const double source_volume = VMP::internal::volume(mesh, mesh.source);
  for(const std::array<int, 4>& cell : mesh.cells)
  {
    if(!VMP::internal::is_positive(image, cell))
    {
      ++number_of_inverted_cells;
      continue;
    }
    const VMP::internal::Matrix_3 X = VMP::internal::edge_matrix(mesh.source, cell);
    const VMP::internal::Matrix_3 J = VMP::internal::edge_matrix(image, cell) * X.inverse();
    VMP::internal::add_cell(distortion, X.determinant() / 6 / source_volume,
                            VMP::internal::signed_singular_values_3(J));
  }

  const Eigen::Index n = mesh.number_of_vertices() - mesh.number_of_free_vertices;
  const Eigen::Matrix3Xd targets = mesh.target.rightCols(n);
  const double diagonal = (targets.rowwise().maxCoeff() - targets.rowwise().minCoeff()).norm();
  const Eigen::VectorXd distances = (image.rightCols(n) - targets).colwise().norm() / diagonal;
  return JSON_object().add("vertices", static_cast<std::size_t>(mesh.number_of_vertices()))
                      .add("boundary_vertices", static_cast<std::size_t>(n))
                      .add("cells", mesh.cells.size())
                      .add("inverted_cells", number_of_inverted_cells)
                      .add("angle_mean", distortion.angle_mean)
                      .add("angle_max", distortion.angle_max)
                      .add("volume_mean", distortion.volume_mean)
                      .add("volume_max", distortion.volume_max)
                      .add("unavoidable_angle", VMP::internal::unavoidable_angle_distortion_3(mesh))
                      .add("distance_max", distances.maxCoeff())
                      .add("distance_mean", distances.mean()).text();
}

int main(int argc, char* argv[])
{
  try
  {
    if(argc != 5)
      throw std::runtime_error("usage: measure_map SOURCE.mesh TARGET MAP.mesh NAME");
    const Map_problem problem(argv[1], argv[2]);
    const Eigen::Matrix3Xd image = problem.read(argv[3]);
    const std::string name = argv[4];
    std::ofstream report(name + ".json");
    report << measure(problem.mesh(), image) << "\n";
    if(!report.flush())
      throw std::runtime_error(name + ".json: the file cannot be written");
    problem.write_VTU(name + ".vtu", image);
    return EXIT_SUCCESS;
  }
  catch(const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
