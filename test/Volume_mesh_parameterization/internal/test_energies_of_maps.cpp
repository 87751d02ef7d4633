// Effects of the adapters of energies on the minimizers.
#include "catch.h"
#include "cube_mesh.h"
#include "fixed_boundary.h"

#include <CGAL/Volume_mesh_parameterization/ARAP_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Barrier_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Bounded_angle_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Conjugate_gradient_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Dirichlet_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/LPM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/LSCM_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Lp_stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/MIPS_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Power_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Stretch_energy_3.h>
#include <CGAL/Volume_mesh_parameterization/Symmetric_Dirichlet_energy_3.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>

namespace VMP = CGAL::Volume_mesh_parameterization;

using Eigen::Matrix3d;
using CGAL::Volume_mesh_parameterization::internal::Matrix3Xd;
using Eigen::Vector3d;
using VMP::internal::Numbered_mesh_3;

namespace {

// The worst of the cells with a free vertex.
struct Map
{
  VMP::Error_code status;
  double largest_angle_distortion = 0;
  double largest_stretch = 0;       // the largest stretch energy of a cell
  double smallest_determinant = 1;
};

template <typename Energy>
Map minimize(const Numbered_mesh_3& mesh, const Energy& energy)
{
  using Solver = VMP::Conjugate_gradient_solver_traits_3<>;
  Solver solver;
  const fixed_boundary::Outcome outcome = fixed_boundary::run(mesh, energy, solver, 300);

  Map map;
  map.status = outcome.status;
  const Matrix3Xd& u = outcome.positions;
  const double scale = std::cbrt(VMP::internal::volume(mesh, mesh.source) / VMP::internal::volume(mesh, u));
  for(const std::array<int, 4>& cell : mesh.cells)
  {
    if(*std::min_element(cell.begin(), cell.end()) >= mesh.number_of_free_vertices)
      continue;
    const Matrix3d J = scale * VMP::internal::edge_matrix(u, cell) * VMP::internal::edge_matrix(mesh.source, cell).inverse();
    const Vector3d s = Eigen::JacobiSVD<Matrix3d, Eigen::NoQRPreconditioner>(J).singularValues();
    map.largest_angle_distortion = (std::max)(map.largest_angle_distortion, s[0] / s[2] + s[2] / s[0]);
    map.largest_stretch = (std::max)(map.largest_stretch, s.cwiseInverse().squaredNorm());
    map.smallest_determinant = (std::min)(map.smallest_determinant, J.determinant());
  }
  return map;
}

} // namespace

TEMPLATE_TEST_CASE("Each energy with a barrier is minimized without an inverted cell", "[energies]",
                   VMP::Barrier_energy_3<VMP::Dirichlet_energy_3>, VMP::Barrier_energy_3<VMP::ARAP_energy_3>,
                   VMP::Barrier_energy_3<VMP::LPM_energy_3>, VMP::Barrier_energy_3<VMP::LSCM_energy_3>,
                   VMP::MIPS_energy_3, VMP::Symmetric_Dirichlet_energy_3, VMP::Lp_stretch_energy_3,
                   VMP::Power_energy_3<VMP::Stretch_energy_3>)
{
  const Map map = minimize(ring(6), TestType());
  CHECK(map.status == VMP::OK);
  CHECK(map.smallest_determinant > 0);
}

TEST_CASE("A larger power lowers the largest stretch", "[energies]")
{
  const Numbered_mesh_3 mesh = ring(6);
  double previous = minimize(mesh, VMP::Stretch_energy_3()).largest_stretch;
  for(const int exponent : {2, 4, 8})
  {
    const Map map = minimize(mesh, VMP::Power_energy_3<VMP::Stretch_energy_3>(exponent));
    CHECK(map.status == VMP::OK);
    CHECK(map.largest_stretch < previous);
    previous = map.largest_stretch;
  }
}

TEST_CASE("The relaxed bound on the angle distortion is approached from a start that exceeds it", "[energies]")
{
  const Numbered_mesh_3 mesh = pulled_cube(6, 0.1, 2.1);
  const double unbounded = minimize(mesh, VMP::Stretch_energy_3()).largest_angle_distortion;
  for(const double factor : {0.9, 0.7, 0.5})
  {
    const double bound = factor * unbounded;
    const Map map = minimize(mesh, VMP::Bounded_angle_energy_3<VMP::Stretch_energy_3>(bound));
    CHECK(map.status == VMP::OK);
    CHECK(map.largest_angle_distortion < 1.05 * bound);
    CHECK(map.largest_angle_distortion > 0.9 * bound); // not stricter than needed
  }
}

TEST_CASE("A bound that cannot be met does no harm", "[energies]")
{
  const Map map = minimize(pulled_cube(6, 0.1, 2.1), VMP::Bounded_angle_energy_3<VMP::Stretch_energy_3>(2.1));
  CHECK(map.status == VMP::OK);
  CHECK(map.smallest_determinant > 0);
}
