// Limits that copies share, and rows that threads fill.
#include "catch.h"

#include <CGAL/Volume_mesh_parameterization/internal/Map/Newton/Progress_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Compressed_rows.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

TEST_CASE("Copies of a budget are one: what one of them was told, all know")
{
  int number_of_questions = 0;
  const VMP::internal::Budget budget((std::numeric_limits<double>::infinity)(), [&] { return ++number_of_questions != 3; });
  VMP::internal::Progress_3 progress(budget, 10);
  CHECK(!budget.is_exhausted());
  CHECK(progress.may_continue());
  CHECK(!progress.may_continue());
  CHECK(budget.is_exhausted());
  CHECK(number_of_questions == 3);
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("Threads put items into the rows that one thread does, in order")
{
  constexpr std::size_t number_of_rows = 9001, number_of_items = 200003;
  const auto for_each_row_of = [](const std::size_t i, const auto& f) // two rows at most, and none of the last one
  {
    f(i * i % (number_of_rows - 1));
    if(i % 3 == 0)
      f(i % 17);
  };
  std::vector<std::vector<std::size_t> > expected(number_of_rows);
  for(std::size_t i = 0; i < number_of_items; ++i)
    for_each_row_of(i, [&](const std::size_t row) { expected[row].push_back(i); });
  for(const bool is_parallel : { false, true })
  {
    const VMP::internal::Compressed_rows<std::size_t> rows(number_of_rows, number_of_items, for_each_row_of, is_parallel);
    for(std::size_t row = 0; row < number_of_rows; ++row)
      REQUIRE(std::vector<std::size_t>(rows.items.data() + rows.begin[row], rows.items.data() + rows.begin[row + 1])
              == expected[row]);
  }
}
#endif
