// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_COMPLEX_PARAMETERIZATION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_COMPLEX_PARAMETERIZATION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_mode.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Inserted_vertex_3.h>
#include <CGAL/Volume_mesh_parameterization/Linear_constraint_3.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Soft_boundary_parameters.h>
#include <CGAL/Volume_mesh_parameterization/internal/Complex/Numbered_complex_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Infeasibility/describe_infeasibility_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Infeasibility/prove_infeasibility_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/blocking_cells_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/check_input_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Mesh/exact_orientation_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refinement/split_edges_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Engine_run.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stages/Parameterization_3.h>
#include <CGAL/Volume_mesh_parameterization/make_parameterizable.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// What is asked for beyond a minimizer: how the boundary is to be met, and perhaps a bound.
template <typename C3t3, bool HasAngleBound>
struct Parameterization_options
{
  static constexpr bool has_angle_bound = HasAngleBound; // needs a further energy, which takes time to compile

  Boundary_mode mode;
  Soft_boundary_parameters soft;
  std::vector<Linear_constraint_3<typename C3t3::Vertex_handle> > constraints;
  bool do_refine; // only if C3t3 is not const
  bool do_slide;
  bool use_volume_weights;
  double maximal_angle_distortion; // if there is a bound
};

// From a complex to the images of its vertices: numbers it, checks the input, tries the stages that
// are allowed, and refines the complex between two attempts.
template <typename ConcurrencyTag, typename C3t3, typename Energy, typename Solver, typename Visitor,
          typename VertexIsConstrainedMap, typename BoundaryMap, typename Options>
class Complex_parameterization_3
{
public:
  Complex_parameterization_3(C3t3& c3t3, const VertexIsConstrainedMap is_constrained, const BoundaryMap target,
                             const Energy& energy, Solver& solver, Visitor& visitor, const Run_limits& limits,
                             const Options& options)
    : m_c3t3(c3t3), m_is_constrained(is_constrained), m_target(target),
      m_energy(energy), m_solver(solver), m_run(visitor, limits), m_options(options)
  {}

  template <typename VertexUVWMap>
  Parameterization_result run(VertexUVWMap uvw_map)
  {
    while(attempt(uvw_map)) {}
    m_result.seconds_total = m_run.seconds();
    return m_result;
  }

private:
  using Vertex_handle = typename C3t3::Vertex_handle;
  using Complex = Numbered_complex_3<C3t3>;
  using Stages = Parameterization_3<ConcurrencyTag, Energy, Solver, Visitor>;

  // Refines where the boundary map forces cells to be degenerate; false if nothing is to be done.
  bool make_complex_parameterizable()
  {
    if constexpr(!std::is_const<C3t3>::value)
      if(m_options.do_refine && !m_is_parameterizable)
      {
        m_is_parameterizable = true;
        m_result.number_of_added_vertices = make_parameterizable(
          m_c3t3, parameters::boundary_map(m_target).vertex_is_constrained_map(m_is_constrained));
        return m_result.number_of_added_vertices > 0;
      }
    return false;
  }

  // Returns true if the complex has been refined and another attempt makes sense.
  template <typename VertexUVWMap>
  bool attempt(VertexUVWMap uvw_map)
  {
    const double begin = m_run.seconds();
    const Complex complex(m_c3t3, m_is_constrained, m_target);
    const Input_check check = check_input(complex);
    m_result.seconds_numbering += m_run.seconds() - begin;
    const bool can_be_fixed = check.status == OK;
    const bool can_be_soft = can_be_fixed || check.status == ERROR_PRESCRIBED_CELL_INVERTED;
    if(can_be_soft && make_complex_parameterizable())
      return true;
    if(!can_be_fixed && !(can_be_soft && m_options.mode != Boundary_mode::FIXED))
      return false;

    Numbered_mesh_3 mesh = complex.mesh();
    mesh.has_volume_weights = m_options.use_volume_weights;
    m_run.template announce<Solver>(mesh);
    Stages stages(mesh, m_energy, m_solver, m_run, m_options.do_slide, m_result);
    bool needs_soft = m_options.mode != Boundary_mode::FIXED;
    if(can_be_fixed && m_options.mode != Boundary_mode::SOFT && m_images.empty())
    {
      stages.run_with_fixed_boundary();
      if(m_result.status == ERROR_NOT_FLIP_FREE)
        diagnose(complex.mesh(), stages.positions());
      needs_soft = needs_soft && !stages.is_flip_free() && !m_run.is_interrupted();
    }
    if(needs_soft)
    {
      stages.run_with_soft_boundary(m_options.soft, numbered_constraints(complex), soft_start(complex));
      const bool is_stuck = m_result.status == ERROR_BOUNDARY_NOT_REACHED
        || (m_result.status == ERROR_NOT_CONVERGED && !stages.meets_boundary());
      if(is_stuck && refine(complex, stages.positions()))
      {
        m_number_of_raises = (std::max)(stages.number_of_raises(), std::size_t(1)) - 1; // the last one was useless
        return true;
      }
    }

    if(m_options.do_slide && !m_run.is_interrupted())
      stages.slide([&](const std::size_t v) { return get(m_is_constrained, complex.vertices()[v]); });

    if constexpr(Options::has_angle_bound)
      if(!m_run.is_interrupted())
        stages.bound_angle_distortion(m_options.maximal_angle_distortion);

    stages.evaluate();
    if(m_result.status == ERROR_NOT_CONVERGED)
      m_result.message.clear(); // the boundary that was not met at first is met now
    const std::string reason = m_result.status == OK || m_result.message.empty() ? "" : " " + m_result.message;
    m_result.message = get_error_message(m_result.status) + reason;
    if(m_result.has_valid_map)
      write(complex, stages.positions(), uvw_map);
    return false;
  }

  Input_check check_input(const Complex& complex)
  {
    const Input_check check = check_input_3(complex.mesh());
    m_result.number_of_vertices = complex.vertices().size();
    m_result.number_of_cells = complex.mesh().cells.size();
    m_result.number_of_boundary_vertices = complex.number_of_boundary_vertices();
    m_result.status = check.status;
    m_result.message = check.message;
    return check;
  }

  // The approach of the boundary goes on where the last refinement interrupted it. If the complex may be refined, that is
  // done soon; otherwise larger weights get a chance.
  Soft_boundary_start_3 soft_start(const Complex& complex) const
  {
    Soft_boundary_start_3 result;
    result.patience = may_refine() ? 1 : 2;
    if(m_images.empty())
      return result;
    Eigen::Matrix3Xd positions(3, complex.vertices().size());
    for(std::size_t v = 0; v < complex.vertices().size(); ++v)
      positions.col(v) = m_images.at(complex.vertices()[v]);
    if(inverted_cells(complex.mesh(), positions).number > 0) // by rounding at a new vertex
      return result;
    result.positions = positions;
    result.number_of_raises = m_number_of_raises;
    return result;
  }

  // More new vertices would mean that refinement does not help. A small complex may need many in proportion.
  bool may_refine() const
  {
    const std::size_t limit = (std::max)(m_result.number_of_vertices / 10, std::size_t(1000));
    return m_options.do_refine && m_result.number_of_added_vertices <= limit;
  }

  // Splits the interior edges of the cells that keep the boundary from its targets, and the map with them; or, where these
  // are fewer, of those that the fixed boundary had left inverted, to try it again. Returns false if that is not allowed,
  // or there is nothing to split.
  bool refine(const Complex& complex, const Eigen::Matrix3Xd& image)
  {
    if constexpr(std::is_const<C3t3>::value)
      return false;
    else
    {
      if(!may_refine())
        return false;
      const std::vector<std::size_t> blocking_cells = blocking_cells_3(complex.mesh(), image);
      const bool is_easier_fixed = !m_inverted_cells.empty() && m_inverted_cells.size() < blocking_cells.size();
      std::vector<std::pair<Vertex_handle, Vertex_handle> > edges;
      for(const std::size_t c : is_easier_fixed ? m_inverted_cells : blocking_cells)
      {
        const std::array<int, 4>& cell = complex.mesh().cells[c];
        for(int i = 0; i < 4; ++i)
          for(int j = i + 1; j < 4; ++j)
            edges.emplace_back(complex.vertices()[cell[i]], complex.vertices()[cell[j]]);
      }
      std::vector<Inserted_vertex_3<Vertex_handle> > inserted;
      split_edges_3(m_c3t3, edges, std::back_inserter(inserted));
      m_result.number_of_added_vertices += inserted.size();
      m_result.number_of_infeasibility_proofs = 0; // they were for the complex as it was
      m_result.message.clear();
      m_inverted_cells.clear();

      // If the last refinement has not helped, it is better to start all again, with the complex as it is now.
      const double distance = largest_distance_to_target(complex.mesh(), image);
      if(!is_easier_fixed && (m_images.empty() || distance < 0.9 * m_distance))
        keep(complex, image, inserted);
      else
        m_images.clear();
      m_distance = distance;
      return !inserted.empty();
    }
  }

  // The images from which the approach goes on, with those of new vertices.
  void keep(const Complex& complex, const Eigen::Matrix3Xd& image,
            const std::vector<Inserted_vertex_3<Vertex_handle> >& inserted)
  {
    for(std::size_t v = 0; v < complex.vertices().size(); ++v)
      m_images[complex.vertices()[v]] = image.col(v);
    for(const Inserted_vertex_3<Vertex_handle>& i : inserted)
      m_images[i.vertex] = (m_images.at(i.simplex[0]) + m_images.at(i.simplex[1])) / 2;
  }

  // Keeps and says why no map was found with fixed boundary, with a proof if there is one.
  void diagnose(const Numbered_mesh_3& mesh, const Eigen::Matrix3Xd& image)
  {
    const std::vector<Infeasibility_proof_3> proofs = prove_infeasibility_3(mesh, image);
    m_result.number_of_infeasibility_proofs = proofs.size();
    for(std::size_t c = 0; c < mesh.cells.size(); ++c)
      if(!is_positive(image, mesh.cells[c]))
        m_inverted_cells.push_back(c);
    m_result.message = proofs.empty() ? describe_inverted_cells(m_inverted_cells)
                                      : describe_infeasibility(proofs, mesh);
  }

  std::vector<Linear_constraint_3<int> > numbered_constraints(const Complex& complex) const
  {
    std::vector<Linear_constraint_3<int> > result;
    for(const auto& constraint : m_options.constraints)
    {
      result.emplace_back();
      result.back().value = constraint.value;
      for(const auto& term : constraint.terms)
        result.back().terms.push_back({ complex.number(term.vertex), term.coefficient });
    }
    return result;
  }

  template <typename VertexUVWMap>
  static void write(const Complex& complex, const Eigen::Matrix3Xd& image, VertexUVWMap uvw_map)
  {
    using Point_3 = typename C3t3::Triangulation::Geom_traits::Point_3;
    for(std::size_t v = 0; v < complex.vertices().size(); ++v)
      put(uvw_map, complex.vertices()[v], Point_3(image(0, v), image(1, v), image(2, v)));
  }

  C3t3& m_c3t3;
  VertexIsConstrainedMap m_is_constrained;
  BoundaryMap m_target;
  const Energy& m_energy;
  Solver& m_solver;
  Engine_run<Visitor> m_run;
  const Options& m_options;
  Parameterization_result m_result;
  bool m_is_parameterizable = false;
  std::vector<std::size_t> m_inverted_cells; // that the fixed boundary has left in this complex
  std::unordered_map<Vertex_handle, Eigen::Vector3d> m_images; // after a refinement, what was reached before
  std::size_t m_number_of_raises = 0;                          // how often the weight had been raised
  double m_distance = 0;                                       // and the largest distance to a target
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COMPLEX_COMPLEX_PARAMETERIZATION_3_H
