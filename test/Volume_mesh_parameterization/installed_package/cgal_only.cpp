// A translation unit that knows CGAL but not the package, linked with one that knows both.
#include <CGAL/Named_function_parameters.h>

int number_of_iterations()
{
  auto np = CGAL::parameters::verbose(true).number_of_iterations(200);
  return CGAL::parameters::get_parameter(np, CGAL::internal_np::number_of_iterations);
}
