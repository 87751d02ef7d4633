// A unit whose flags let the compiler reorder operations, and tell no macro of it, is refused when it runs.
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <cstdlib>

int main()
{
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  try { CGAL::Volume_mesh_parameterization::internal::require_operations_as_written(); }
  catch(const CGAL::Precondition_exception&) { return EXIT_SUCCESS; }
  return EXIT_FAILURE;
}
