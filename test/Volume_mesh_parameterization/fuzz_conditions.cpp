// Maps random meshes with random conditions of vertices, by one thread and by several. Checks that both give the same bits, that
// no cell is inverted in exact arithmetic, and that the conditions are met.
//
// Usage: fuzz_conditions [NUMBER_OF_INPUTS [SEED [KIND_OF_CONDITIONS]]]; kind 10 has open patches and intersections
#include "fuzz_inputs.h"
#include "fuzz_loop.h"

#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/ARAP_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Any_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Implicit_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/LPM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/LSCM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/MIPS_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Surface_intersection_3.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/facets_3.h>
#include <CGAL/Volume_mesh_parameterization/orient_tetrahedron_soup.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/determinant.h>

#include <boost/property_map/function_property_map.hpp>

#include <cfenv>
#include <cstring>
#include <functional>
#include <map>
#include <optional>
#include <set>

namespace VMP = CGAL::Volume_mesh_parameterization;
namespace params = CGAL::parameters;

using Condition = VMP::Vertex_condition_3;
using Eigen::Vector3d;

template <typename Point>
Vector3d vector(const Point& p) { return Vector3d(p[0], p[1], p[2]); }

// Rounds a number to a type. Without `volatile`, g++ 12 leaves out the rounding of vectors at -O2.
template <typename NT>
double rounded(const double x)
{
  const volatile NT result = static_cast<NT>(x);
  return result;
}

// Returns by exact arithmetic whether the cell of four points is positive.
template <typename Point>
bool is_positive(const Point& a, const Point& b, const Point& c, const Point& d)
{
  using FT = CGAL::Exact_rational;
  if(!vector(a).allFinite() || !vector(b).allFinite() || !vector(c).allFinite() || !vector(d).allFinite())
    return false;
  const auto edge = [&](const Point& p, const int i) -> FT { return FT(p[i]) - FT(a[i]); };
  return CGAL::determinant<FT>(edge(b, 0), edge(b, 1), edge(b, 2), edge(c, 0), edge(c, 1), edge(c, 2),
                               edge(d, 0), edge(d, 1), edge(d, 2)) > 0;
}

template <typename Point>
bool has_positive_cells(const VMP::Tetrahedron_soup_3& soup, const std::vector<Point>& points)
{
  return std::all_of(soup.cells.begin(), soup.cells.end(), [&](const std::array<std::size_t, 4>& cell)
  { return is_positive(points[cell[0]], points[cell[1]], points[cell[2]], points[cell[3]]); });
}

// A point without a cell has an image that is not a number.
template <typename Point>
bool has_same_bits(const std::vector<Point>& a, const std::vector<Point>& b)
{ return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Point)) == 0); }

using Facets = std::vector<std::array<std::size_t, 3> >;

std::set<std::size_t> vertices_of(const Facets& facets)
{
  std::set<std::size_t> result;
  for(const std::array<std::size_t, 3>& facet : facets)
    result.insert(facet.begin(), facet.end());
  return result;
}

// An ellipsoid or a cylinder, or what scales in between give.
struct Quadric
{
  Vector3d center, factors; // of the squared coordinates from the center

  double value(const std::array<double, 3>& p) const { return factors.dot((vector(p) - center).cwiseAbs2()) - 1; }
  std::array<double, 3> gradient(const std::array<double, 3>& p) const
  {
    const Vector3d g = 2 * factors.cwiseProduct(vector(p) - center);
    return { g[0], g[1], g[2] };
  }
};

struct Oblique_plane
{
  Vector3d point, normal;

  double value(const std::array<double, 3>& p) const { return normal.dot(vector(p) - point); }
  std::array<double, 3> gradient(const std::array<double, 3>&) const { return { normal[0], normal[1], normal[2] }; }
};

// Returns the distance to a triangle, by projections on it and its sides.
double distance(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
  Eigen::Matrix<double, 3, 2> edges;
  edges << b - a, c - a;
  const Eigen::Vector2d t = edges.colPivHouseholderQr().solve(p - a);
  double result = t.minCoeff() >= 0 && t.sum() <= 1 ? (a + edges * t - p).norm() : (a - p).norm();
  for(const auto& [q, r] : { std::pair(a, b), std::pair(a, c), std::pair(b, c) })
    if(const Vector3d d = r - q; d.squaredNorm() > 0)
      result = (std::min)(result, (q + std::clamp(d.dot(p - q) / d.squaredNorm(), 0., 1.) * d - p).norm());
  return result;
}

// Also larger meshes than other programs have, and bodies far from the origin for their size.
VMP::Tetrahedron_soup_3 random_body(Random& random)
{
  VMP::Tetrahedron_soup_3 soup = random_soup(random);
  if(random.one_in(6))
    soup = source_soup(cube_mesh(static_cast<int>(4 + random.below(4)), 0.15));
  soup.cell_references.assign(soup.cells.size(), 0);
  if(random.one_in(3))
  {
    const Vector3d offset = random.vector(random.pick({0., 1e3, 1e6, 1e9}));
    const double scale = random.pick({1., 1e-12, 1e12});
    for(std::array<double, 3>& p : soup.points)
      for(int i = 0; i < 3; ++i)
        p[i] = scale * (p[i] + offset[i]);
  }
  VMP::orient_tetrahedron_soup(soup);
  return soup;
}

Eigen::Matrix3d random_motion(Random& random)
{
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  switch(random.below(6))
  {
    case 0: return Vector3d(-1, -1, 1).asDiagonal();
    case 1: return Vector3d(-1, 1, 1).asDiagonal();
    case 2: return identity + 0.4 * random_matrix(random).cwiseMax(-1).cwiseMin(1);
    case 3: return Eigen::AngleAxisd(random.real(3.14), random.vector(1).normalized()).toRotationMatrix();
    default: return identity;
  }
}

Vector3d random_direction(Random& random)
{
  const Vector3d direction = random.one_in(2) ? Vector3d(Vector3d::Unit(static_cast<Eigen::Index>(random.below(3)))
                                                         * random.pick({1., -1., 2., 1e-5}))
                                              : random.vector(random.pick({1., 1e-6, 1e100}));
  return direction.isZero(0) ? Vector3d(Vector3d::UnitX()) : direction;
}

Condition plane_or_line(const bool is_plane, const Vector3d& d)
{ return is_plane ? Condition::in_plane(d[0], d[1], d[2]) : Condition::on_line(d[0], d[1], d[2]); }

Condition random_condition(Random& random)
{
  switch(random.below(4))
  {
    case 0: return Condition();
    case 1: return Condition::at_target();
    default: return plane_or_line(random.one_in(2), random_direction(random));
  }
}

VMP::Any_energy_3 random_energy(Random& random)
{
  switch(random.below(10))
  {
    case 0: return VMP::Stretch_energy_3();
    case 1: return VMP::MIPS_energy_3();
    case 2: return VMP::ARAP_energy_3();
    case 3: return VMP::Dirichlet_energy_3();
    case 4: return VMP::LSCM_energy_3();
    case 5: return VMP::LPM_energy_3();
    default: return VMP::Symmetric_Dirichlet_energy_3();
  }
}

// All arguments of a call.
class Problem
{
public:
  Problem(Random& random, const std::optional<std::size_t> given_kind)
    : m_soup(random_body(random)), m_energy(random_energy(random)), m_conditions(m_soup.points.size()),
      m_targets(m_soup.points.size(), { nan, nan, nan })
  {
    for(const std::array<double, 3>& p : m_soup.points)
    {
      m_low = m_low.cwiseMin(vector(p));
      m_high = m_high.cwiseMax(vector(p));
    }
    choose_conditions(random, given_kind);
    if(random.one_in(20))
      m_targets[random.below(m_targets.size())][random.below(3)] = random.extreme_number();
    m_mode = random.pick({VMP::Boundary_mode::AUTO, VMP::Boundary_mode::FIXED, VMP::Boundary_mode::SOFT});
    m_refinement = random.pick({VMP::Refinement_mode::HELPFUL, VMP::Refinement_mode::NEEDED, VMP::Refinement_mode::BOUNDARY});
    m_may_refine = random.one_in(3);
    m_number_of_iterations = random.pick({1000, 1000, 3});
  }

  // Images have coordinates of the type NT.
  template <typename NT>
  std::string run() const
  {
    const Mapped<NT> mapped = map<NT, CGAL::Sequential_tag>();
    check(mapped);
    expect(std::fegetround() == FE_TONEAREST, "the rounding mode is as before");
#ifdef CGAL_LINKED_WITH_TBB
    const Mapped<NT> by_threads = map<NT, CGAL::Parallel_tag>();
    if(mapped.result.status != VMP::ERROR_INTERRUPTED && by_threads.result.status != VMP::ERROR_INTERRUPTED)
    {
      expect(by_threads.result.message == mapped.result.message, "threads do not change the message");
      expect(has_same_bits(by_threads.images, mapped.images), "threads do not change the images");
      expect(has_same_bits(by_threads.soup.points, mapped.soup.points) && by_threads.soup.cells == mapped.soup.cells,
             "threads do not change what is refined");
    }
#endif
    return VMP::get_error_message(mapped.result.status);
  }

private:
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

  template <typename NT>
  struct Mapped
  {
    VMP::Tetrahedron_soup_3 soup;
    std::vector<std::array<NT, 3> > images;
    VMP::Parameterization_result result;
  };

  void set(const std::size_t v, const Condition& condition, const Eigen::Matrix3d& motion, const Vector3d& shift)
  {
    const Vector3d middle = (m_low + m_high) / 2, target = motion * (vector(m_soup.points[v]) - middle) + middle + shift;
    m_conditions[v] = condition;
    m_targets[v] = { target[0], target[1], target[2] };
  }

  void choose_conditions(Random& random, const std::optional<std::size_t> given_kind)
  {
    const Eigen::Matrix3d motion = random_motion(random);
    const Vector3d shift = random.one_in(8) ? random.vector(size() * random.pick({0.1, 1., 1e3})) : Vector3d(Vector3d::Zero());
    const Facets facets = VMP::internal::boundary_facets_3(m_soup.cells);
    const std::set<std::size_t> boundary = vertices_of(facets);
    const std::size_t drawn_kind = random.below(11), kind = given_kind.value_or(drawn_kind);
    const std::size_t number_of_points = m_soup.points.size(), number_of_planes = 1 + random.below(3);
    const int axis = static_cast<int>(random.below(3));
    const Vector3d direction = random_direction(random);
    for(std::size_t handles = kind < 3 ? kind : 0; handles > 0; --handles)
      set(random.below(number_of_points), Condition::at_target(), motion, shift);
    for(std::size_t v = 0; v < number_of_points; ++v)
    {
      const bool is_on_boundary = boundary.count(v) > 0;
      const Vector3d p = vector(m_soup.points[v]);
      if(kind == 3 || (kind == 4 && (!is_on_boundary || random.one_in(5))))
        set(v, random_condition(random), motion, shift);
      else if((kind == 5 && is_on_boundary && (p[axis] == m_low[axis] || p[axis] == m_high[axis]))
              || (kind == 6 && is_on_boundary && !random.one_in(4)))
        set(v, Condition::at_target(), motion, shift);
      else if(kind == 6 && is_on_boundary)
        set(v, plane_or_line(random.one_in(2), direction), motion, shift);
      else if(kind == 7)
        set(v, condition_of_symmetry(p, number_of_planes), motion, shift);
      else if(kind > 7 && is_on_boundary)
        set(v, Condition::at_target(), motion, shift);
    }
    if(kind == 8)
      slide_on_quadric(random, boundary);
    if(kind == 9)
      slide_on_boundary(random, facets);
    if(kind == 10)
      slide_on_intersection(random, facets);
  }

  void slide_on_quadric(Random& random, const std::set<std::size_t>& boundary)
  {
    const double radius = size() * random.pick({0.3, 0.9, 3.}), z = random.pick({0., 0.2, 1.});
    m_quadric = { (m_low + m_high) / 2, Vector3d(1, random.pick({0.5, 1.}), z) / (radius * radius) };
    const VMP::Any_surface_3 surface = VMP::Implicit_surface_3(m_quadric);
    for(const std::size_t v : boundary)
      if(!random.one_in(5))
        m_conditions[v] = random.one_in(10) ? random_condition(random) : Condition::on_surface(surface);
  }

  // Slides in the boundary, perhaps beside other conditions, or on its image, on one part of it, or from other places to it.
  void slide_on_boundary(Random& random, Facets facets)
  {
    const bool is_on_part = random.one_in(4), is_moved = random.one_in(3);
    if(is_on_part)
      facets.resize(1 + facets.size() / 2);
    m_triangles = facets;
    m_points = m_targets;
    for(std::size_t v = 0; v < m_points.size(); ++v)
      if(!vector(m_points[v]).allFinite())
        m_points[v] = m_soup.points[v];
    if(random.one_in(3))
    {
      for(const std::size_t v : vertices_of(facets))
        if(!random.one_in(5))
          m_conditions[v] = random.one_in(10) ? random_condition(random) : Condition::in_boundary();
      return;
    }
    const VMP::Triangulated_surface_3 surface(m_points, facets);
    for(const std::size_t v : vertices_of(facets))
    {
      m_conditions[v] = surface.condition(v);
      if(is_moved)
        for(double& x : m_targets[v])
          x += random.real(0.1 * size());
    }
  }

  // Slides on a part of the boundary as it is, and there in planes or on quadrics, which pass through the vertices. These begin on
  // it, or beyond its border.
  void slide_on_intersection(Random& random, Facets facets)
  {
    facets.resize(1 + facets.size() / (1 + random.below(3)));
    m_triangles = facets;
    m_points = m_soup.points;
    const VMP::Any_surface_3 patch = VMP::Triangulated_surface_3(m_points, facets);
    std::map<std::size_t, Vector3d> edges; // along the patch: surfaces that are orthogonal to them do not only touch the patch
    for(const auto& [u, v, w] : facets)
      for(const auto& [a, b] : { std::pair(u, v), std::pair(v, w), std::pair(w, u) })
        edges[a] = vector(m_points[b]) - vector(m_points[a]);
    const Vector3d factors(1, random.pick({0.5, 1.}), random.pick({0.1, 1.}));
    const double largest_shift = size() * random.pick({0., 0., 0.001, 0.02, 0.1});
    const std::size_t part_on_curves = random.pick({2, 10, 50});
    const bool do_others_stay = !random.one_in(4);
    for(std::size_t v = 0; v < m_targets.size(); ++v)
      if(do_others_stay && !std::isnan(m_targets[v][0]))
        m_targets[v] = m_soup.points[v];
    for(const auto& [v, edge] : edges)
    {
      const Vector3d p = vector(m_points[v]), center = p + random.pick({1.5, 3., 10.}) * edge;
      const Oblique_plane plane = { p, edge + random.vector(0.3 * edge.norm()) };
      const Quadric quadric = { center, factors / factors.dot((p - center).cwiseAbs2()) };
      const bool is_in_plane = random.one_in(2);
      const VMP::Any_surface_3 second = is_in_plane ? VMP::Any_surface_3(VMP::Implicit_surface_3(plane))
                                                    : VMP::Any_surface_3(VMP::Implicit_surface_3(quadric));
      if(!random.one_in(part_on_curves))
        m_conditions[v] = Condition::on_surface(patch);
      else
      {
        m_conditions[v] = Condition::on_curve(VMP::Surface_intersection_3(patch, second));
        m_second_values[v] = [is_in_plane, plane, quadric](const std::array<double, 3>& p)
        {
          return is_in_plane ? plane.value(p) / plane.normal.norm() : quadric.value(p) / vector(quadric.gradient(p)).norm();
        };
      }
      for(double& x : m_targets[v])
        x += random.real(largest_shift);
    }
  }

  // Returns the condition of a point in some of the lowest planes orthogonal to axes.
  Condition condition_of_symmetry(const Vector3d& p, const std::size_t number_of_planes) const
  {
    Vector3d is_in_plane = Vector3d::Zero();
    for(int i = 0; i < static_cast<int>(number_of_planes); ++i)
      is_in_plane[i] = p[i] == m_low[i];
    const double n = is_in_plane.sum();
    return n == 0 ? Condition() : n == 3 ? Condition::at_target()
         : n == 1 ? plane_or_line(true, is_in_plane) : plane_or_line(false, Vector3d::Ones() - is_in_plane);
  }

  template <typename NT, typename ConcurrencyTag>
  Mapped<NT> map() const
  {
    const auto condition = [&](const std::size_t v) { return v < m_conditions.size() ? m_conditions[v] : Condition(); };
    const auto np = params::energy(m_energy)
      .vertex_condition_map(boost::make_function_property_map<std::size_t>(condition))
      .boundary_mode(m_mode).number_of_iterations(m_number_of_iterations).maximum_running_time(5);
    Mapped<NT> mapped;
    mapped.soup = m_soup;
    const VMP::Tetrahedron_soup_3& constant = m_soup;
    mapped.result = m_may_refine
      ? CGAL::stretch_minimizing_volume_parameterization<ConcurrencyTag>(
          mapped.soup, m_targets, mapped.images, np.refinement_mode(m_refinement))
      : CGAL::stretch_minimizing_volume_parameterization<ConcurrencyTag>(constant, m_targets, mapped.images, np);
    return mapped;
  }

  template <typename NT>
  void check(const Mapped<NT>& mapped) const
  {
    const VMP::Parameterization_result& result = mapped.result;
    expect(result.status != VMP::OK || result.has_valid_map, "success means a valid map");
    expect(result.has_valid_map || mapped.images.empty(), "valid maps only are written");
    expect(has_positive_cells(mapped.soup, mapped.soup.points), "refinement makes positive cells");
    expect(std::equal(m_soup.points.begin(), m_soup.points.end(), mapped.soup.points.begin()), "refinement moves no point");
    if(!result.has_valid_map)
      return;
    expect(has_positive_cells(mapped.soup, mapped.images), "the map has positive cells");
    expect(result.message.find("nan") == std::string::npos, "the message has numbers");
    if(result.status != VMP::OK && result.status != VMP::ERROR_NOT_CONVERGED)
      return;
    for(const std::array<std::size_t, 4>& cell : m_soup.cells)
      for(const std::size_t v : cell)
        check_condition<NT>(v, vector(mapped.images[v]));
  }

  // Targets and coordinates that are prescribed have these very bits. Other planes and lines are met within rounding.
  template <typename NT>
  void check_condition(const std::size_t v, const Vector3d& image) const
  {
    const Condition& condition = m_conditions[v];
    const std::array<double, 3>& t = m_targets[v];
    const Vector3d target(rounded<NT>(t[0]), rounded<NT>(t[1]), rounded<NT>(t[2])), d = vector(condition.direction());
    const std::string vertex = "vertex " + std::to_string(v);
    if(condition.kind() == Condition::AT_TARGET)
      expect(image == target, vertex + " is at its target");
    if(condition.kind() == Condition::IN_BOUNDARY) // facets that are nearly in one plane count as if they were
      expect(distance_to_triangles(image, targets_or_points()) <= 1e-6 * (size() + image.norm()), vertex + " is in the boundary");
    if(condition.is_sliding())
      expect(distance_to_surface(image) <= 64 * std::numeric_limits<NT>::epsilon() * (size() + image.norm()),
             vertex + " is on its surface");
    if(const auto second = m_second_values.find(v); second != m_second_values.end())
      expect(std::abs(second->second({ image[0], image[1], image[2] }))
               <= 64 * std::numeric_limits<NT>::epsilon() * (size() + image.norm()), vertex + " is on its second surface");
    if(condition.kind() != Condition::IN_PLANE && condition.kind() != Condition::ON_LINE)
      return;
    const bool is_plane = condition.kind() == Condition::IN_PLANE;
    if((d.array() != 0).count() == 1)
    {
      for(int i = 0; i < 3; ++i)
        expect((d[i] != 0) != is_plane || image[i] == target[i], vertex + " has the coordinate of its target");
      return;
    }
    const Vector3d u = (d / d.cwiseAbs().maxCoeff()).normalized(), off = image - target, along = u * u.dot(off);
    const double unit_of_rounding = std::numeric_limits<NT>::epsilon() / 2 * (image.norm() + target.norm() + size());
    expect((is_plane ? along : Vector3d(off - along)).norm() <= 64 * unit_of_rounding, vertex + " is in its plane or on its line");
  }

  double distance_to_surface(const Vector3d& p) const
  {
    const std::array<double, 3> q = { p[0], p[1], p[2] };
    if(m_triangles.empty())
      return std::abs(m_quadric.value(q)) / vector(m_quadric.gradient(q)).norm();
    return distance_to_triangles(p, m_points);
  }

  double distance_to_triangles(const Vector3d& p, const std::vector<std::array<double, 3> >& points) const
  {
    double result = std::numeric_limits<double>::infinity();
    for(const auto& [a, b, c] : m_triangles)
      result = (std::min)(result, distance(p, vector(points[a]), vector(points[b]), vector(points[c])));
    return result;
  }

  // The targets, and the points of the source where there are none: vertices slide there, too.
  std::vector<std::array<double, 3> > targets_or_points() const
  {
    std::vector<std::array<double, 3> > result = m_targets;
    for(std::size_t v = 0; v < result.size(); ++v)
      if(std::isnan(result[v][0]))
        result[v] = m_soup.points[v];
    return result;
  }

  double size() const { return (m_high - m_low).maxCoeff(); }

  VMP::Tetrahedron_soup_3 m_soup;
  VMP::Any_energy_3 m_energy;
  std::vector<Condition> m_conditions;
  std::vector<std::array<double, 3> > m_targets;
  Quadric m_quadric; // on which vertices slide, or triangles if there are any
  Facets m_triangles;
  std::vector<std::array<double, 3> > m_points; // of the triangles
  std::map<std::size_t, std::function<double(const std::array<double, 3>&)> > m_second_values; // distances, of curves
  Vector3d m_low = Vector3d::Constant(std::numeric_limits<double>::infinity()), m_high = -m_low;
  VMP::Boundary_mode m_mode = VMP::Boundary_mode::AUTO;
  VMP::Refinement_mode m_refinement = VMP::Refinement_mode::HELPFUL;
  bool m_may_refine = false;
  int m_number_of_iterations = 0;
};

// Runs a random input, and returns how the run ended.
std::string run_input(const std::uint64_t seed, const std::optional<std::size_t> kind)
{
  Random random(seed);
  try
  {
    const Problem problem(random, kind);
    return random.one_in(5) ? problem.run<float>() : problem.run<double>();
  }
  catch(const VMP::Input_error&)
  {
    return "The mesh is refused.";
  }
}

int main(int argc, char* argv[])
{
  std::optional<std::size_t> kind;
  if(argc > 3)
    kind = std::strtoull(argv[3], nullptr, 10);
  return run_inputs(argc, argv, [&](const std::uint64_t seed) { return run_input(seed, kind); });
}
