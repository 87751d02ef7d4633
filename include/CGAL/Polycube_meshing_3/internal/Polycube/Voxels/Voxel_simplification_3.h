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

// Pieces of a surface that keep together while the polycube changes, one for each face of the voxels at first, and what labels
// of them cost.
struct Pieces_of_surface_3
{
  std::vector<std::array<double, 6> > costs;           // of the labels
  std::vector<std::map<std::size_t, double> > borders; // lengths of borders with other pieces

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
  // Takes the faces of the voxels at first, which the pieces belong to, and whether each move keeps corners where those of the
  // pieces are.
  Voxel_simplification_3(Voxels_3& voxels, const Voxel_faces_3& faces, const Pieces_of_surface_3& pieces,
                         const bool do_keep_corners)
    : m_voxels(voxels), m_faces(faces), m_pieces(pieces), m_do_keep_corners(do_keep_corners), m_face_of_piece(faces.faces),
      m_is_moving(voxels.is_inside.size(), false)
  {
    for(std::size_t c = 0; c < m_face_of_piece.size(); ++c)
      m_pieces_on_face[m_face_of_piece[c]].push_back(c);
  }

  // Makes borders shorter and shorter.
  void run(const Budget& budget)
  {
    constexpr double maximum_smoothing = 0.02; // in units of the body; with more, details of fingers and tails vanished
    constexpr int maximum_number_of_sweeps = 20; // a guess
    for(const double part : { 0.125, 0.25, 0.5, 1. })
    {
      m_smoothing = part * maximum_smoothing;
      for(int i = 0; i < maximum_number_of_sweeps && !budget.is_exhausted() && sweep(); ++i) {}
    }
  }

  // Returns the face of the voxels, as they are now, that each piece belongs to.
  const std::vector<std::size_t>& face_of_piece() const { return m_face_of_piece; }

private:
  static constexpr int maximum_number_of_layers = 4; // a guess

  // Changes by moves, which can be undone: voxels, and pieces with the faces that they had before.
  struct Changes
  {
    std::vector<std::size_t> voxels;
    std::vector<std::pair<std::size_t, std::size_t> > faces;
  };

  // Returns the voxels of the chart of a face.
  std::vector<std::size_t> chart(const std::size_t face) const
  {
    std::vector<std::size_t> result(1, face / 6);
    std::set<std::size_t> seen = { face / 6 };
    for(std::size_t i = 0; i < result.size(); ++i)
      for_each_orthogonal_direction(face % 6, [&](const std::size_t e)
      {
        const std::size_t next = face_across(m_voxels, 6 * result[i] + face % 6, e);
        if(next % 6 == face % 6 && seen.insert(next / 6).second)
          result.push_back(next / 6);
      });
    return result;
  }

  // Moves a chart by a layer, and returns its voxels then; nothing if the topology would change.
  std::optional<std::vector<std::size_t> > move(const std::vector<std::size_t>& chart, const std::size_t d, const bool is_outward,
                                                Changes& changes)
  {
    constexpr int margin = 2; // voxels beside the body are asked for
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
    set(layer, is_outward);
    if(characteristic_of_voxels_3(m_voxels, lo - ones, hi + ones) != before)
    {
      set(layer, !is_outward);
      return std::nullopt;
    }
    changes.voxels.insert(changes.voxels.end(), layer.begin(), layer.end());
    give_pieces(moved_faces(layer, d, is_outward), changes);
    for(std::size_t& v : layer)
      v = is_outward ? v : m_voxels.index(m_voxels.voxel(v) - step);
    return layer;
  }

  void set(const std::vector<std::size_t>& voxels, const bool is_inside)
  {
    for(const std::size_t v : voxels)
      m_voxels.is_inside[v] = is_inside;
  }

  // Returns each face that has vanished with a layer, which was added or removed before, and the face that takes its pieces. A
  // face of the chart gives them to the moved chart. A face beside the layer gives them to the next face of its side, or to the
  // moved chart if there is none.
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
      const std::size_t old_face = is_outward ? 6 * m_voxels.index(below) + d : 6 * i + d,
                        new_face = is_outward ? 6 * i + d : 6 * m_voxels.index(below) + d;
      result.emplace_back(old_face, new_face);
      for_each_orthogonal_direction(d, [&](const std::size_t e)
      {
        const Eigen::Vector3i w = v + (is_outward ? -1 : 1) * step_of_direction(e);
        if(m_voxels.contains(w) != is_outward || m_is_moving[m_voxels.index(w)])
          return;
        const Eigen::Vector3i beyond = is_outward ? Eigen::Vector3i(w + step) : below; // has the side beyond, if it goes on
        const bool continues = m_voxels.contains(beyond) && !m_voxels.contains(beyond + step_of_direction(e));
        result.emplace_back(6 * (is_outward ? m_voxels.index(w) : i) + e, continues ? 6 * m_voxels.index(beyond) + e : new_face);
      });
    }
    for(const std::size_t v : layer)
      m_is_moving[v] = false;
    return result;
  }

  void give_pieces(const std::vector<std::pair<std::size_t, std::size_t> >& faces, Changes& changes)
  {
    std::vector<std::pair<std::vector<std::size_t>, std::size_t> > moves; // all at once, as faces may be old and new ones
    for(const auto& [from, to] : faces)
      if(const auto it = m_pieces_on_face.find(from); it != m_pieces_on_face.end())
      {
        moves.emplace_back(std::move(it->second), to);
        m_pieces_on_face.erase(it);
      }
    for(const auto& [pieces, to] : moves)
      for(const std::size_t c : pieces)
      {
        changes.faces.emplace_back(c, m_face_of_piece[c]);
        m_face_of_piece[c] = to;
        m_pieces_on_face[to].push_back(c);
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

  // Returns by how much changes have lowered the cost.
  double gain(const Changes& changes) const
  {
    std::map<std::size_t, std::size_t> old_labels;
    for(const auto& [piece, face] : changes.faces)
      old_labels.emplace(piece, face % 6); // the first entry is the oldest one
    const auto old_label = [&](const std::size_t piece)
    {
      const auto it = old_labels.find(piece);
      return it == old_labels.end() ? m_face_of_piece[piece] % 6 : it->second;
    };
    double result = 0;
    for(const auto& [piece, label] : old_labels)
    {
      const std::size_t new_label = m_face_of_piece[piece] % 6;
      if(new_label == label)
        continue;
      result += m_pieces.costs[piece][label] - m_pieces.costs[piece][new_label];
      for(const auto& [other, length] : m_pieces.borders[piece])
      {
        const std::size_t label_of_other = old_label(other), new_label_of_other = m_face_of_piece[other] % 6;
        const double part = label_of_other != new_label_of_other ? 0.5 : 1; // as both are visited
        result += m_smoothing * part * length * ((label != label_of_other) - (new_label != new_label_of_other));
      }
    }
    return result;
  }

  // Moves each chart as far as that lowers the cost most. Returns whether any has moved.
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
      const std::vector<std::size_t> voxels = chart(face);
      for(const std::size_t v : voxels)
        visited.insert(6 * v + face % 6);
      has_moved = move_best(voxels, face % 6) || has_moved;
    }
    return has_moved;
  }

  bool move_best(const std::vector<std::size_t>& voxels, const std::size_t d)
  {
    double best_gain = 1e-12; // more than rounding
    int best = 0;             // layers, outward or inward
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
        present = chart(6 * moved->front() + d);
        if(present.size() != moved->size()) // it has been merged with another one
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
  std::unordered_map<std::size_t, std::vector<std::size_t> > m_pieces_on_face; // as they are now
  std::vector<bool> m_is_moving;
  double m_smoothing = 0;
  std::mt19937 m_random; // of a fixed seed
};

} // namespace CGAL::Polycube_meshing_3::internal

#endif // CGAL_POLYCUBE_MESHING_3_INTERNAL_POLYCUBE_VOXELS_VOXEL_SIMPLIFICATION_3_H
