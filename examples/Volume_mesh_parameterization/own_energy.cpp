// Bends a ball, with an energy of one's own: stretch, and the third power of what singular values exceed a limit by.
#include <CGAL/stretch_minimizing_volume_parameterization.h>
#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/select.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>

#include <Eigen/Dense>

#include <boost/property_map/function_property_map.hpp>

#include <cstdlib>
#include <iostream>
#include <unordered_map>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = K::Point_3;
using Domain = CGAL::Labeled_mesh_domain_3<K>;
using Tr = CGAL::Mesh_triangulation_3<Domain>::type;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;
using Vertex_handle = C3t3::Vertex_handle;

namespace params = CGAL::parameters;
namespace VMP = CGAL::Volume_mesh_parameterization;

// A symmetric function of the singular values s, with its derivatives, for one cell (T is double) or several at once, some
// of which may be on either side of a branch.
struct Limited_stretch_energy_3
{
  double weight;
  double limit = 1.5;
  VMP::Stretch_energy_3 stretch = {};

  template <typename T> using Vector = Eigen::Matrix<T, 3, 1>;
  template <typename T> using Matrix = Eigen::Matrix<T, 3, 3>;

  template <typename T>
  Vector<T> excess(const Vector<T>& s) const
  {
    using VMP::select;
    return s.unaryExpr([this](const T& x) { return select(x > T(limit), x - T(limit), T(0)); });
  }

  template <typename T>
  T value(const Vector<T>& s) const { return stretch.value(s) + T(weight) * excess(s).array().cube().sum(); }

  template <typename T>
  Vector<T> gradient(const Vector<T>& s) const
  {
    return stretch.gradient(s) + T(3 * weight) * excess(s).cwiseAbs2();
  }

  template <typename T>
  Matrix<T> hessian(const Vector<T>& s) const
  {
    return stretch.hessian(s) + Matrix<T>((T(6 * weight) * excess(s)).asDiagonal());
  }
};

int main()
{
  const auto ball = [](const Point_3& p) { return CGAL::squared_distance(p, Point_3(0, 0, 0)) - 1; };
  const Domain domain = Domain::create_implicit_mesh_domain(ball, K::Sphere_3(CGAL::ORIGIN, 2.));
  const CGAL::Mesh_criteria_3<Tr> criteria(params::facet_angle = 25, params::facet_size = 0.2,
                                           params::facet_distance = 0.02, params::cell_radius_edge_ratio = 2,
                                           params::cell_size = 0.2);
  // limits of time, as by default, would give another mesh in each run
  const C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::exude(params::time_limit = 0));

  const auto point = c3t3.triangulation().geom_traits().construct_point_3_object();
  const auto bend = [&point](const Vertex_handle v)
  {
    const Point_3 p = point(v->point());
    return Point_3(2 * p.x(), p.y() + p.x() * p.x(), p.z());
  };

  std::cout << "weight   angle distortion (mean, max)   volume distortion (mean, max)\n";
  for(const double weight : {0., 1., 100.})
  {
    std::unordered_map<Vertex_handle, Point_3> uvw;
    const VMP::Parameterization_result result = CGAL::stretch_minimizing_volume_parameterization(
      c3t3, VMP::make_vertex_point_map(uvw),
      params::boundary_map(boost::make_function_property_map<Vertex_handle>(bend))
             .energy(Limited_stretch_energy_3{weight}));
    if(result.status != VMP::OK)
    {
      std::cerr << result.message << std::endl;
      return EXIT_FAILURE;
    }
    const VMP::Distortion_3& d = result.distortion_at_source_volume;
    std::cout << weight << "\t " << d.angle_mean << ", " << d.angle_max
              << "\t\t" << d.volume_mean << ", " << d.volume_max << "\n";
  }
  return EXIT_SUCCESS;
}
