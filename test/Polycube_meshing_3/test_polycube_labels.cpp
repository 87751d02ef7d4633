// Labels that are proposed for a surface, and labels that no polycube has.
#include "bricks.h"

#include <CGAL/Polycube_meshing_3/internal/Polycube/Polycube_map_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/repair_labels_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

TEST_CASE("labels are proposed for a cylinder")
{
  Labelled_complex complex(bricks({8, 8, 6}, is_box, [](const double x, const double y, const double z) -> std::array<double, 3>
  {
    const double u = x - 4, v = y - 4, length = std::hypot(u, v), radius = (std::max)(std::abs(u), std::abs(v));
    return (length == 0) ? in_place(0, 0, z) : in_place(u * radius / length, v * radius / length, z);
  }));
  REQUIRE(complex.parameterize() == VMP::OK);
  CHECK(faces_of_image(complex).size() == 6);
}

TEST_CASE("where the normals turn around, a face is put between")
{
  // a tent: no facet looks upwards, and the ridge is so sharp that its sides could have opposite labels
  Labelled_complex complex(bricks({12, 10, 6}, is_box, [](const double x, const double y, const double z)
  {
    return in_place(x, y, z * (1 + 4 * (6 - std::abs(x - 6))));
  }));
  REQUIRE(complex.parameterize() == VMP::OK);
  CHECK(faces_of_image(complex).size() == 6);
}

TEST_CASE("labels that no polycube has are named")
{
  Labelled_complex complex(bricks(size, is_box, in_place));
  copy_labels(complex, complex);
  CHECK(complex.parameterize_with_labels() == VMP::OK);
  const auto status = [&](const auto& change)
  {
    const std::map<Facet, std::size_t> labels = complex.labels;
    for(auto& entry : complex.labels)
      entry.second = change(entry.first, entry.second);
    const VMP::Error_code result = complex.parameterize_with_labels();
    CHECK(complex.image.empty());
    complex.labels = labels;
    return result;
  };
  const auto one_label = [](const Facet&, std::size_t) -> std::size_t { return 0; };
  CHECK(status(one_label) == VMP::ERROR_NO_POLYCUBE);
  const auto opposite_neighbours = [](const Facet&, const std::size_t label) { return label == 2 ? 1 : label; };
  CHECK(status(opposite_neighbours) == VMP::ERROR_NO_POLYCUBE);
  const auto inside_out = [](const Facet&, const std::size_t label) { return label ^ 1; };
  CHECK(status(inside_out) == VMP::ERROR_NO_POLYCUBE);
  const auto without_top = [](const Facet&, const std::size_t label) -> std::size_t { return label == 4 ? 0 : label; };
  CHECK(status(without_top) == VMP::ERROR_NO_POLYCUBE);
  const auto island = [&](const Facet& f, const std::size_t label) -> std::size_t
  {
    const Point_3 p = CGAL::centroid(complex.source_triangle(f)[0], complex.source_triangle(f)[1],
                                     complex.source_triangle(f)[2]);
    return label == 4 && std::abs(p.x() - 3) < 1 && std::abs(p.y() - 3) < 1 ? 0 : label;
  };
  CHECK(status(island) == VMP::ERROR_NO_POLYCUBE);
}

TEST_CASE("a face of a polycube has no handle, although a cube on it would turn its border by the right angles")
{
  // a frame with a cube on it, all around which there is one label
  Labelled_complex complex(bricks({8, 8, 2}, [](const int x, const int y, const int z)
  {
    return z == 0 ? x / 2 != 2 || y / 2 != 2 : x == 1 && y == 1;
  }, in_place));
  copy_labels(complex, complex);
  CHECK(complex.parameterize_with_labels() == VMP::OK);
  for(auto& [facet, label] : complex.labels)
  {
    const std::array<Point_3, 3> t = complex.source_triangle(facet);
    if(CGAL::centroid(t[0], t[1], t[2]).z() <= 1)
      label = 4;
  }
  CHECK(complex.parameterize_with_labels() == VMP::ERROR_NO_POLYCUBE);
}
