// Units of four kinds, each compiled with other flags: they map in the same way, by code of their own, and leave each other's
// memory alone.
#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

using Points = std::vector<std::array<double, 3> >;

Points images_by_headers();
Points images_by_engine();
const void* address_of_headers();
const void* address_of_engine();
bool has_polycube_by_engine();
Eigen::MatrixXd square_of_ones(int n);
double sum_of_solution(int n);
int number_of_iterations();

int main()
{
  Eigen::MatrixXd square = square_of_ones(50); // allocated there, freed here
  const bool is_right = square(7, 9) == 50 && number_of_iterations() == 200 && has_polycube_by_engine()
                        && address_of_headers() != address_of_engine();
  square.resize(300, 300);
  const Points a = images_by_headers(), b = images_by_engine();
  double distance = a.size() == b.size() ? 0 : 1;
  for(std::size_t v = 0; v < a.size() && v < b.size(); ++v)
    for(int i = 0; i < 3; ++i)
      distance = (std::max)(distance, std::abs(a[v][i] - b[v][i]));
  std::cout << a.size() << " points, " << distance << " apart" << std::endl;
  return is_right && !a.empty() && distance < 1e-6 && std::abs(sum_of_solution(20) - 2) < 1e-9 ? EXIT_SUCCESS : EXIT_FAILURE;
}
