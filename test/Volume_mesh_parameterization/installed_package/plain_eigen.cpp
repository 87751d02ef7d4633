// A unit that knows Eigen and not the package.
#include <Eigen/Dense>

Eigen::MatrixXd square_of_ones(const int n)
{
  const Eigen::MatrixXd ones = Eigen::MatrixXd::Ones(n, n);
  return ones * ones;
}

double sum_of_solution(const int n)
{
  Eigen::Matrix3Xd columns = Eigen::Matrix3Xd::Ones(3, n);
  columns.conservativeResize(3, 2 * n);
  columns.rightCols(n).setOnes();
  const Eigen::VectorXd sums = columns.colwise().sum().transpose();
  const Eigen::Matrix2d A = 3 * Eigen::Matrix2d::Identity();
  return (A.inverse() * sums.head<2>()).sum();
}
