#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_PLAIN_NEWTON_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_PLAIN_NEWTON_MAP_3_H

#include "Shifted_newton_3.h"

#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Soft_boundary_search_3.h>

#include <Eigen/Dense>

#include <cmath>
#include <cstddef>

// The map with soft boundary, of one weight, by the solver of Jin et al., Remeshing-assisted Optimization for
// Locally Injective Mappings (CGF 2014), without its relaxation. As Soft_boundary_search_3, with which it shares
// its interface, it starts from the aligned source, takes the mean over the cells and measures lengths
// where the target has volume 1.
template <typename Energy>
class Plain_newton_map_3
{
public:
  using Mesh = typename Shifted_newton_3<Energy>::Mesh;

  Plain_newton_map_3(const Mesh& mesh, const Energy& energy, const double weight)
    : m_number_of_cells(static_cast<double>(mesh.cells.size())),
      m_weight(weight),
      m_newton(mesh, energy, CGAL::Volume_mesh_parameterization::internal::similarity_alignment_3(mesh))
  {}

  void step()
  {
    const double last = total();
    m_newton.step(m_weight * std::cbrt(m_number_of_cells), [&](double) { return m_newton.target(); });
    m_is_running = m_newton.is_running() && last - total() > 1e-8;
    ++m_step.iteration;
    m_step.step_length = m_newton.step_length();
  }

  const CGAL::Volume_mesh_parameterization::Parameterization_step& last_step() const { return m_step; }
  Eigen::Matrix3Xd positions() const { return m_newton.positions(); }
  double residual() const { return m_newton.distance() / std::cbrt(m_number_of_cells); }
  double weight() const { return m_weight; }
  bool is_relaxing() const { return false; }
  bool is_running() const { return m_is_running; }

private:
  double total() const { return m_newton.energy() / m_number_of_cells + m_weight * residual() * residual(); }

  double m_number_of_cells, m_weight;
  Shifted_newton_3<Energy> m_newton;
  CGAL::Volume_mesh_parameterization::Parameterization_step m_step;
  bool m_is_running = true;
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_PLAIN_NEWTON_MAP_3_H
