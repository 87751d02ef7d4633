// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_VOXEL_SIMPLIFICATION_3_H
#define CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_VOXEL_SIMPLIFICATION_3_H

#include <CGAL/license/Polycube_meshing_3.h>

#include <CGAL/Polycube_meshing_3/internal/Polycube/Label_functional_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/Voxels_3.h>
#include <CGAL/Polycube_meshing_3/internal/Polycube/Voxels/Voxel_faces_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/Budget.h>

#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <unordered_map>

namespace CGAL::Polycube_meshing_3::internal {

// Pieces of a surface, one for each face of the voxels at first. Facets of a piece always have the same label.
struct Pieces_of_surface_3
{
  std::vector<std::array<double, 6> > costs;           // of each piece by label, as in `Label_functional_3`
  std::vector<std::map<std::size_t, double> > borders; // of each piece: lengths of borders with other pieces

  Pieces_of_surface_3(const Boundary_mesh_3& mesh, const Label_functional_3& functional,
                    const std::vector<std::size_t>& piece_of_facet, const std::size_t number_of_pieces)
    : costs(number_of_pieces), borders(number_of_pieces)
  {
    for(std::array<double, 6>& c : costs)
      c.fill(0);
    for(const auto f : mesh.faces())
      for(std::size_t d = 0; d < 6; ++d)
        costs[piece_of_facet[f]][d] += functional.cost(f, d);
    for(const auto h : mesh.halfedges())
      if(const std::size_t a = piece_of_facet[mesh.face(h)], b = piece_of_facet[mesh.face(mesh.opposite(h))]; a != b)
        borders[a][b] += functional.length(h);
  }
};

// Simplifies a body of voxels with handles: its charts move by layers of voxels as long as that lowers the cost of labels of a
// surface. The boundary stays a manifold, and its topology stays.
class Voxel_simplification_3
{
public:
  // Takes the body, which changes, its faces at first, in the order of the pieces, and whether each move must keep the corners of
  // charts where those of the pieces are.
  Voxel_simplification_3(Voxels_3& voxels, const Voxel_faces_3& faces, const Pieces_of_surface_3& pieces,
                         const bool do_keep_corners)
    : m_voxels(voxels), m_faces(faces), m_pieces(pieces), m_do_keep_corners(do_keep_corners), m_face_of_piece(faces.faces),
      m_is_moving(voxels.is_inside.size(), false)
  {
    for(std::size_t piece = 0; piece < m_face_of_piece.size(); ++piece)
      m_pieces_on_face[m_face_of_piece[piece]].push_back(piece);
  }

  // Moves charts until no move lowers the cost, for larger and larger weights of the lengths of borders.
  void run(const Budget& budget)
  {
    constexpr double maximum_smoothing = 0.02; // in units of the body; with more, details of fingers and tails vanished
    constexpr int maximum_number_of_sweeps = 20; // a guess
    for(const double part : { 0.125, 0.25, 0.5, 1. }) // guesses
    {
      m_smoothing = part * maximum_smoothing;
      for(int i = 0; i < maximum_number_of_sweeps && !budget.is_exhausted() && sweep(); ++i) {}
    }
  }

  // Returns for each piece its face of the voxels as they are now.
  const std::vector<std::size_t>& face_of_piece() const { return m_face_of_piece; }

private:
  static constexpr int maximum_number_of_layers = 4; // a guess

  // Changes by moves, which can be undone, in their order.
  struct Changes
  {
    std::vector<std::size_t> voxels; // that were added or removed
    std::vector<std::pair<std::size_t, std::size_t> > faces; // pieces, each with the face that it had before
  };

  // Returns the voxels under the chart of a face.
  std::vector<std::size_t> voxels_of_chart(const std::size_t face) const
  {
    const std::size_t d = direction_of_face(face);
    std::vector<std::size_t> result(1, voxel_of_face(face));
    std::set<std::size_t> seen = { voxel_of_face(face) };
    for(std::size_t i = 0; i < result.size(); ++i)
      for_each_orthogonal_direction(d, [&](const std::size_t e)
      {
        const std::size_t next = face_across(m_voxels, face_of_voxel(result[i], d), e);
        if(direction_of_face(next) == d && seen.insert(voxel_of_face(next)).second)
          result.push_back(voxel_of_face(next));
      });
    return result;
  }

  // Moves a chart of direction d by a layer, which is added outward or removed, and returns the voxels under the chart then.
  // Returns nothing, and changes nothing, if there is no room for the layer, or the topology would change.
  std::optional<std::vector<std::size_t> > move(const std::vector<std::size_t>& chart, const std::size_t d, const bool is_outward,
                                                Changes& changes)
  {
    constexpr int margin = 2; // layers that stay free at the sides of the box, as neighbors of the body are looked at
    const Eigen::Vector3i step = step_of_direction(d), ones = Eigen::Vector3i::Ones();
    std::vector<std::size_t> layer;
    Eigen::Vector3i lo = m_voxels.size, hi = Eigen::Vector3i::Zero();
    for(const std::size_t i : chart)
    {
      const Eigen::Vector3i v = is_outward ? Eigen::Vector3i(m_voxels.voxel(i) + step) : m_voxels.voxel(i);
      const Eigen::Vector3i next = is_outward ? Eigen::Vector3i(v + step) : Eigen::Vector3i(v - step);
      if(!m_voxels.is_in_box(v, margin) || m_voxels.contains(next) == is_outward)
        return std::nullopt;
      layer.push_back(m_voxels.index(v));
      lo = lo.cwiseMin(v);
      hi = hi.cwiseMax(v);
    }
    const auto before = characteristic_of_voxels_3(m_voxels, lo - ones, hi + ones);
    set_inside(layer, is_outward);
    if(characteristic_of_voxels_3(m_voxels, lo - ones, hi + ones) != before)
    {
      set_inside(layer, !is_outward);
      return std::nullopt;
    }
    changes.voxels.insert(changes.voxels.end(), layer.begin(), layer.end());
    give_pieces(moved_faces(layer, d, is_outward), changes);
    for(std::size_t& v : layer)
      v = is_outward ? v : m_voxels.index(m_voxels.voxel(v) - step);
    return layer;
  }

  void set_inside(const std::vector<std::size_t>& voxels, const bool is_inside)
  {
    for(const std::size_t v : voxels)
      m_voxels.is_inside[v] = is_inside;
  }

  // Returns pairs of a face that has vanished with a layer, which was added or removed before, and the face that takes its pieces.
  // A face of the chart gives its pieces to the moved chart. A face beside the layer gives its pieces to the next face of the same
  // side, or to the moved chart if there is none.
  std::vector<std::pair<std::size_t, std::size_t> > moved_faces(const std::vector<std::size_t>& layer, const std::size_t d,
                                                                const bool is_outward)
  {
    std::vector<std::pair<std::size_t, std::size_t> > result;
    const Eigen::Vector3i step = step_of_direction(d);
    for(const std::size_t v : layer)
      m_is_moving[v] = true;
    for(const std::size_t i : layer)
    {
      const Eigen::Vector3i v = m_voxels.voxel(i), below = v - step;
      const std::size_t lower_face = face_of_voxel(m_voxels.index(below), d), upper_face = face_of_voxel(i, d),
                        old_face = is_outward ? lower_face : upper_face, new_face = is_outward ? upper_face : lower_face;
      result.emplace_back(old_face, new_face);
      for_each_orthogonal_direction(d, [&](const std::size_t e)
      {
        const Eigen::Vector3i w = v + (is_outward ? -1 : 1) * step_of_direction(e);
        if(m_voxels.contains(w) != is_outward || m_is_moving[m_voxels.index(w)])
          return;
        const Eigen::Vector3i beyond = is_outward ? Eigen::Vector3i(w + step) : below; // has the next face, if there is one
        const bool has_next = m_voxels.contains(beyond) && !m_voxels.contains(beyond + step_of_direction(e));
        result.emplace_back(face_of_voxel(is_outward ? m_voxels.index(w) : i, e),
                            has_next ? face_of_voxel(m_voxels.index(beyond), e) : new_face);
      });
    }
    for(const std::size_t v : layer)
      m_is_moving[v] = false;
    return result;
  }

  // Gives the pieces on the first face of each pair to the second face.
  void give_pieces(const std::vector<std::pair<std::size_t, std::size_t> >& old_and_new_faces, Changes& changes)
  {
    std::vector<std::pair<std::vector<std::size_t>, std::size_t> > moves; // all at once: an old face may be a new one, too
    for(const auto& [from, to] : old_and_new_faces)
      if(const auto it = m_pieces_on_face.find(from); it != m_pieces_on_face.end())
      {
        moves.emplace_back(std::move(it->second), to);
        m_pieces_on_face.erase(it);
      }
    for(const auto& [pieces, to] : moves)
      for(const std::size_t piece : pieces)
      {
        changes.faces.emplace_back(piece, m_face_of_piece[piece]);
        m_face_of_piece[piece] = to;
        m_pieces_on_face[to].push_back(piece);
      }
  }

  void revert(const Changes& changes)
  {
    for(auto it = changes.faces.rbegin(); it != changes.faces.rend(); ++it)
    {
      const auto [piece, face] = *it;
      std::vector<std::size_t>& pieces = m_pieces_on_face[m_face_of_piece[piece]];
      pieces.erase(std::find(pieces.begin(), pieces.end(), piece));
      if(pieces.empty())
        m_pieces_on_face.erase(m_face_of_piece[piece]);
      m_face_of_piece[piece] = face;
      m_pieces_on_face[face].push_back(piece);
    }
    for(const std::size_t v : changes.voxels)
      m_voxels.is_inside[v] = !m_voxels.is_inside[v];
  }

  // Returns by how much changes have lowered the cost of labels and borders.
  double gain(const Changes& changes) const
  {
    std::map<std::size_t, std::size_t> old_labels;
    for(const auto& [piece, face] : changes.faces)
      old_labels.emplace(piece, direction_of_face(face)); // the first entry is the oldest one
    const auto label = [&](const std::size_t piece) { return direction_of_face(m_face_of_piece[piece]); };
    const auto old_label = [&](const std::size_t piece)
    {
      const auto it = old_labels.find(piece);
      return it == old_labels.end() ? label(piece) : it->second;
    };
    double result = 0;
    for(const auto& [piece, before] : old_labels)
    {
      const std::size_t after = label(piece);
      if(after == before)
        continue;
      result += m_pieces.costs[piece][before] - m_pieces.costs[piece][after];
      for(const auto& [other, length] : m_pieces.borders[piece])
      {
        const std::size_t before_at_other = old_label(other), after_at_other = label(other);
        const double part = before_at_other != after_at_other ? 0.5 : 1; // the border is met from both pieces if both changed
        result += m_smoothing * part * length * ((before != before_at_other) - (after != after_at_other));
      }
    }
    return result;
  }

  // Moves each chart, in a random order, as far as that lowers the cost most. Returns whether any has moved.
  bool sweep()
  {
    std::vector<std::size_t> faces;
    for(const auto& [face, pieces] : m_pieces_on_face)
      faces.push_back(face);
    std::sort(faces.begin(), faces.end());
    for(std::size_t i = faces.size(); i > 1; --i) // `std::shuffle()` differs between libraries
      std::swap(faces[i - 1], faces[m_random() % i]);
    std::set<std::size_t> visited;
    bool has_moved = false;
    for(const std::size_t face : faces)
    {
      if(m_pieces_on_face.count(face) == 0 || visited.count(face) > 0)
        continue;
      const std::vector<std::size_t> voxels = voxels_of_chart(face);
      for(const std::size_t v : voxels)
        visited.insert(face_of_voxel(v, direction_of_face(face)));
      has_moved = move_best(voxels, direction_of_face(face)) || has_moved;
    }
    return has_moved;
  }

  // Moves a chart of direction d by the number of layers that lowers the cost most. Returns whether the chart has moved: not if
  // neighbors, or corners that must stay, would no longer be those of the pieces.
  bool move_best(const std::vector<std::size_t>& voxels, const std::size_t d)
  {
    double best_gain = 1e-12; // more than rounding
    int best = 0;             // number of layers, negative if inward
    for(const bool is_outward : { true, false })
    {
      Changes changes;
      std::vector<std::size_t> present = voxels;
      for(int layer = 1; layer <= maximum_number_of_layers; ++layer)
      {
        const auto moved = move(present, d, is_outward, changes);
        if(!moved)
          break;
        if(const double g = gain(changes); g > best_gain)
        {
          best_gain = g;
          best = is_outward ? layer : -layer;
        }
        present = voxels_of_chart(face_of_voxel(moved->front(), d));
        if(present.size() != moved->size()) // the chart has been merged with another one
          break;
      }
      revert(changes);
    }
    if(best == 0)
      return false;
    Changes changes;
    std::optional<std::vector<std::size_t> > present = voxels;
    for(int layer = 0; layer < std::abs(best) && present; ++layer)
      present = move(*present, d, best > 0, changes);
    const Charts_of_voxels_3 charts(m_voxels);
    if(are_neighbors_those_of_charts(charts, m_faces, m_face_of_piece)
       && (!m_do_keep_corners || are_corners_those_of_charts(charts, m_faces, m_face_of_piece)))
      return true;
    revert(changes);
    return false;
  }

  Voxels_3& m_voxels;
  const Voxel_faces_3& m_faces;
  const Pieces_of_surface_3& m_pieces;
  const bool m_do_keep_corners;
  std::vector<std::size_t> m_face_of_piece;
  std::unordered_map<std::size_t, std::vector<std::size_t> > m_pieces_on_face; // of the voxels as they are now
  std::vector<bool> m_is_moving; // voxels of a layer, within moved_faces()
  double m_smoothing = 0;
  std::mt19937 m_random; // of a fixed seed
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_VOXEL_SIMPLIFICATION_3_H
