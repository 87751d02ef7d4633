// Units of four kinds, each compiled with other flags: they map in the same way, by code of their own, and leave each other's
// memory alone.
#include <Eigen/Dense>

#include <algorithm>
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
Points polycube_by_headers();
Points polycube_by_engine();
std::size_t number_of_hexahedra_by_headers();
bool has_slid_by_headers();
bool has_read_surface_by_headers();
Eigen::MatrixXd square_of_ones(int n);
double sum_of_solution(int n);
int number_of_iterations();

static double distance_of(const Points& a, const Points& b)
{
  double result = a.size() == b.size() && !a.empty() ? 0 : 1;
  for(std::size_t v = 0; v < a.size() && v < b.size(); ++v)
    for(int i = 0; i < 3; ++i)
      result = (std::max)(result, std::abs(a[v][i] - b[v][i]));
  return result;
}

int main()
{
  Eigen::MatrixXd square = square_of_ones(50); // allocated there, freed here
  const bool is_right = square(7, 9) == 50 && number_of_iterations() == 200 && number_of_hexahedra_by_headers() > 0
                        && has_slid_by_headers() && has_read_surface_by_headers() && address_of_headers() != address_of_engine();
  square.resize(300, 300);
  const double distance = distance_of(images_by_headers(), images_by_engine());
  const double distance_of_polycubes = distance_of(polycube_by_headers(), polycube_by_engine());
  std::cout << "maps " << distance << " apart, polycubes " << distance_of_polycubes << std::endl;
  return is_right && distance < 1e-6 && distance_of_polycubes < 1e-6 && std::abs(sum_of_solution(20) - 2) < 1e-9
       ? EXIT_SUCCESS : EXIT_FAILURE;
}
