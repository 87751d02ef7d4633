// A visitor that lets a computation go on for some questions, and counts them; and boundaries whose maps it ends.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_VISITOR_THAT_ENDS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_VISITOR_THAT_ENDS_H

#include "catch.h"

#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <functional>
#include <limits>

struct Visitor_that_ends : CGAL::Volume_mesh_parameterization::Default_visitor
{
  std::size_t number_of_questions = 0, last_question = (std::numeric_limits<std::size_t>::max)();

  bool goes_on() { return ++number_of_questions < last_question; }
};

// `parameterize(np)` of a boundary: a "no" to any question of some, evenly spaced, ends it at once, with nothing written.
template <typename Parameterize, typename Image>
void check_interruption(const Parameterize& parameterize, Image& image)
{
  namespace VMP = CGAL::Volume_mesh_parameterization;
  Visitor_that_ends all;
  REQUIRE(parameterize(CGAL::parameters::visitor(std::ref(all))) == VMP::OK);
  for(std::size_t k = 0; k <= 8; ++k)
  {
    image.clear();
    Visitor_that_ends some;
    some.last_question = 1 + k * (all.number_of_questions - 1) / 8;
    CHECK(parameterize(CGAL::parameters::visitor(std::ref(some))) == VMP::ERROR_INTERRUPTED);
    CHECK(some.number_of_questions == some.last_question);
    CHECK(image.empty());
  }
  CHECK(parameterize(CGAL::parameters::maximum_running_time(0)) == VMP::ERROR_INTERRUPTED);
  CHECK(image.empty());
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_VISITOR_THAT_ENDS_H
