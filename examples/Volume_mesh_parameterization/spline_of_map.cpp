// Fits a trivariate B-spline to the inverse of a map to the cube, and writes it for G+Smo.
#include "mesh_body.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Cube_boundary_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Volume_map_3.h>

#include <Eigen/Dense>
#include <unsupported/Eigen/Splines>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <unordered_map>
#include <vector>

using Eigen::MatrixXd;
using Spline = Eigen::Spline<double, 1>;

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

constexpr int degree = 3, intervals = 8;

// Values of the B-splines (columns) at n points that divide [0, 1] equally (rows).
MatrixXd values_of_splines(const Spline::KnotVectorType& knots, const int n)
{
  MatrixXd values = MatrixXd::Zero(n, intervals + degree);
  for(int i = 0; i < n; ++i)
  {
    const double t = double(i) / (n - 1);
    values.row(i).segment(Spline::Span(t, degree, knots) - degree, degree + 1) = Spline::BasisFunctions(t, degree, knots);
  }
  return values;
}

// Multiplies by a matrix along each axis of a grid, whose points are the rows of `grid`, x first.
MatrixXd multiply_along_axes(const MatrixXd& A, MatrixXd grid)
{
  for(int axis = 0; axis < 3; ++axis) // each turn makes the first axis the last one
    grid = (A * Eigen::Map<MatrixXd>(grid.data(), A.cols(), grid.size() / A.cols())).transpose().eval();
  return Eigen::Map<MatrixXd>(grid.data(), 3, grid.size() / 3).transpose();
}

int main(int argc, char* argv[])
{
  const double size = (argc > 1) ? std::atof(argv[1]) : 0.1; // of the cells
  const auto banana = [](const Point_3& p)
  { return 0.25 * p.x() * p.x() + std::pow(p.y() - 0.2 * p.x() * p.x(), 2) + p.z() * p.z() - 1; };
  C3t3 body = mesh_body(Domain::create_implicit_mesh_domain(banana, K::Sphere_3(CGAL::ORIGIN, 9.)),
                        CGAL::Mesh_criteria_3<Tr>(params::facet_angle = 25, params::facet_size = size,
                          params::facet_distance = size / 8, params::cell_radius_edge_ratio = 2, params::cell_size = size));
  std::unordered_map<Vertex_handle, Point_3> uvw;
  const auto uvw_map = VMP::make_vertex_point_map(uvw);
  const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
    body, uvw_map, params::boundary_parameterizer(VMP::Cube_boundary_parameterizer_3()));
  std::cout << result.message << std::endl;
  if(result.status != VMP::OK)
    return EXIT_FAILURE;

  // least squares at a grid of points, and the error at a finer one
  const VMP::Volume_map_3 map(body, uvw_map);
  Spline::KnotVectorType knots(intervals + 2 * degree + 1);
  knots << Eigen::RowVectorXd::Zero(degree), Eigen::RowVectorXd::LinSpaced(intervals + 1, 0, 1), Eigen::RowVectorXd::Ones(degree);
  const auto preimages_on_grid = [&](const int n)
  {
    std::vector<Point_3> grid; // x changes first, then y, then z
    for(int i = 0; i < n * n * n; ++i)
      grid.emplace_back(double(i % n) / (n - 1) - 0.5, double(i / n % n) / (n - 1) - 0.5, double(i / (n * n)) / (n - 1) - 0.5);
    MatrixXd preimages(grid.size(), 3);
    const auto locations = map.nearest_preimages(grid);
    for(int i = 0; i < n * n * n; ++i)
      preimages.row(i) << locations[i]->point.x(), locations[i]->point.y(), locations[i]->point.z();
    return preimages;
  };
  const MatrixXd coefficients = multiply_along_axes(
    values_of_splines(knots, 25).completeOrthogonalDecomposition().pseudoInverse(), preimages_on_grid(25));
  const MatrixXd preimages = preimages_on_grid(41), spline = multiply_along_axes(values_of_splines(knots, 41), coefficients);
  const double diagonal = (preimages.colwise().maxCoeff() - preimages.colwise().minCoeff()).norm();
  const double error = (spline - preimages).rowwise().norm().maxCoeff() / diagonal;
  std::cout << coefficients.rows() << " coefficients, largest error " << 100 * error << " % of the diagonal" << std::endl;

  std::ofstream file("spline.xml");
  file.precision(17);
  file << "<xml>\n<Geometry type=\"TensorBSpline3\" id=\"0\">\n<Basis type=\"TensorBSplineBasis3\">\n";
  for(int axis = 0; axis < 3; ++axis)
    file << "<Basis type=\"BSplineBasis\" index=\"" << axis << "\"><KnotVector degree=\"" << degree << "\">" << knots
         << "</KnotVector></Basis>\n";
  file << "</Basis>\n<coefs geoDim=\"3\">\n" << coefficients << "\n</coefs>\n</Geometry>\n</xml>\n";
  return file.flush() && error < 0.05 ? EXIT_SUCCESS : EXIT_FAILURE;
}
