// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_PRESCRIBED_POSITION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_PRESCRIBED_POSITION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_result.h>
#include <CGAL/Volume_mesh_parameterization/Surface_intersection_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map/Mesh/projector_3.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

namespace CGAL::Volume_mesh_parameterization::internal {

// The planes, surfaces and curves that are prescribed to a vertex, each by a source: a line of a file, or a patch. The order of
// planes does not matter.
class Prescribed_position_3
{
public:
  using Point = std::array<double, 3>;

  // Condition and target of the vertex; or, if no point meets all planes, the fault of some sources.
  struct Solution
  {
    Vertex_condition_3 condition;
    Point target = {};
    std::set<std::size_t> sources = {};
    std::string fault = {}, reason = {};
  };

  // The size of the body is the unit of rounding.
  Prescribed_position_3(const Point& start, const double size) : m_start(start), m_size(size)
  {
    if(!std::all_of(start.begin(), start.end(), [](const double x) { return std::isfinite(x); }))
      throw Input_error(sentence("A vertex with conditions is at ", describe(Eigen::Vector3d(start.data())), "."));
  }

  // Adds the plane of the points whose scalar product with the normal is the offset, or the plane through the start.
  void add_plane(const Point& normal, const std::optional<double> offset, const std::size_t source)
  {
    for(int axis = 0; axis < 3; ++axis)
      if(normal == unit(axis))
        return m_coordinates.push_back({ axis, offset.value_or(m_start[axis]), source });
    m_planes.push_back({ normal, offset ? Exact_rational(*offset) : exact(normal) * exact(m_start), source });
  }

  const Point& start() const { return m_start; }

  void add_target(const Point& target, const std::size_t source)
  {
    for(int axis = 0; axis < 3; ++axis)
      add_plane(unit(axis), target[axis], source);
  }

  void add_start(const std::size_t source) { add_target(m_start, source); }

  // Adds a surface or curve on which the vertex slides, unless it is there.
  void add_surface(const Vertex_condition_3& condition, const std::size_t source)
  {
    for(const Surface& surface : m_surfaces)
      if(surface.condition.surface() == condition.surface())
        return;
    m_surfaces.push_back({ condition, source });
  }

  Solution solution() const
  {
    const Solution in_planes = solution_in_planes();
    return m_surfaces.empty() || !in_planes.fault.empty() ? in_planes : solution_on_surfaces(in_planes);
  }

private:
  using Vector = Simple_cartesian<Exact_rational>::Vector_3;
  struct Coordinate { int axis; double value; std::size_t source; };
  struct Plane { Point normal; Exact_rational offset; std::size_t source; };
  struct Surface { Vertex_condition_3 condition; std::size_t source; };

  // Coordinates are met to the bit, so they come first.
  Solution solution_in_planes() const
  {
    Point point = m_start;
    std::array<const Coordinate*, 3> met = {};
    for(const Coordinate& coordinate : m_coordinates)
      if(const Coordinate*& first = met[coordinate.axis]; first && first->value != coordinate.value)
        return contradiction({ first->source, coordinate.source });
      else
      {
        first = &coordinate;
        point[coordinate.axis] = coordinate.value;
      }
    return m_planes.empty() ? Solution{ condition(met), point } : solution(met, point);
  }

  // Plane, line or point that planes allow, through a target.
  struct Allowed_by_planes
  {
    Vector_3 target;
    Matrix_3 projector;

    Surface_point_3 nearest_point(const Point& p) const
    {
      const Vector_3 moved = projector * (Vector_3(p[0], p[1], p[2]) - target);
      Point q;
      for(int i = 0; i < 3; ++i) // a coordinate that cannot change is that of the target
        q[i] = projector.row(i) == Vector_3::Zero() ? target[i] : target[i] + moved[i];
      const Vector_3 normal = (Matrix_3::Identity() - projector).col((Vector_3::Ones() - diagonal()).largest_index());
      return { q, { normal[0], normal[1], normal[2] } };
    }

  private:
    Vector_3 diagonal() const { return { projector(0, 0), projector(1, 1), projector(2, 2) }; }
  };

  // Returns the condition of a vertex that planes and surfaces keep. One surface and a plane, or two surfaces, intersect
  // in a curve. More of them meet in a point.
  Vertex_condition_3 condition_on_surfaces(const Vertex_condition_3& in_planes, const Allowed_by_planes& planes) const
  {
    using Condition = Vertex_condition_3;
    const Condition &first = m_surfaces.front().condition, &last = m_surfaces.back().condition;
    const bool is_free = in_planes.dimension() == 3;
    const bool are_surfaces = first.dimension() == 2 && last.dimension() == 2;
    if(is_free && m_surfaces.size() == 1)
      return first;
    if(in_planes.dimension() == 2 && m_surfaces.size() == 1 && are_surfaces)
      return Condition::on_curve(Surface_intersection_3(first.surface(), planes));
    if(is_free && m_surfaces.size() == 2 && are_surfaces)
      return Condition::on_curve(Surface_intersection_3(first.surface(), last.surface()));
    return Condition::at_target();
  }

  // Goes on from the solution of the planes, by projections on one surface after the other, which converge to a common point.
  Solution solution_on_surfaces(Solution solution) const
  {
    constexpr double rounding = 1e-12; // relative to the size
    constexpr int maximum_number_of_projections = 1000; // a guess
    const auto& [x, y, z] = solution.target;
    const Allowed_by_planes planes = { { x, y, z }, projector_3(solution.condition) };
    solution.condition = condition_on_surfaces(solution.condition, planes);
    if(solution.condition.is_sliding())
      solution.target = solution.condition.surface().nearest_point(solution.target).point;
    for(int i = 0; i < maximum_number_of_projections && !is_on_surfaces(solution.target, 0); ++i)
    {
      for(const Surface& surface : m_surfaces)
        solution.target = surface.condition.surface().nearest_point(solution.target).point;
      solution.target = planes.nearest_point(solution.target).point;
    }
    if(is_on_surfaces(solution.target, rounding * m_size))
      return solution;
    std::set<std::size_t> sources;
    for(const Surface& surface : m_surfaces)
      sources.insert(surface.source);
    for(const Coordinate& coordinate : m_coordinates)
      sources.insert(coordinate.source);
    for(const Plane& plane : m_planes)
      sources.insert(plane.source);
    return contradiction(sources);
  }

  bool is_on_surfaces(const Point& p, const double tolerance) const
  {
    return std::all_of(m_surfaces.begin(), m_surfaces.end(), [&](const Surface& surface)
    {
      const Point q = surface.condition.surface().nearest_point(p).point;
      return length_3({ q[0] - p[0], q[1] - p[1], q[2] - p[2] }) <= tolerance;
    });
  }

  static Solution contradiction(std::set<std::size_t> sources)
  { return { {}, {}, std::move(sources), "contradict each other", "no point meets all of them" }; }

  // Goes on from some coordinates by all oblique planes.
  Solution solution(const std::array<const Coordinate*, 3>& met, const Point& point) const
  {
    constexpr double rounding = 1e-12;      // of angles, in radians, and relative to the size
    constexpr double smallest_angle = 1e-9; // planes with a smaller one may be meant to be one plane
    Search search = { exact(point), {}, {} };
    for(int axis = 0; axis < 3; ++axis)
      if(met[axis])
      {
        search.moves.push_back(exact(unit(axis)));
        search.sources_of_moves.push_back({ met[axis]->source });
      }
    std::vector<Plane> planes = m_planes;
    std::sort(planes.begin(), planes.end(), [](const Plane& p, const Plane& q)
    { return std::tie(p.normal, p.offset) < std::tie(q.normal, q.offset); });
    for(const Plane& plane : planes)
    {
      const double sine = search.sine(exact(plane.normal));
      if(sine >= smallest_angle)
        search.meet(plane);
      else if(sine > rounding)
        return { {}, {}, search.sources(plane), "have nearly parallel planes",
                 sentence("the angle is ", sine, " radians, and must be 0 or at least ", smallest_angle) };
      else if(!search.is_met(plane, rounding * m_size))
        return contradiction(search.sources(plane));
    }
    return { search.condition(), rounded(search.point) };
  }

  static Vertex_condition_3 condition(const std::array<const Coordinate*, 3>& met)
  {
    const auto axes = [&](const bool are_met) -> Point
    { return { double(!met[0] != are_met), double(!met[1] != are_met), double(!met[2] != are_met) }; };
    switch(std::count(met.begin(), met.end(), nullptr))
    {
      case 0: return Vertex_condition_3::at_target();
      case 1: return Vertex_condition_3::on_line(axes(false)[0], axes(false)[1], axes(false)[2]);
      case 2: return Vertex_condition_3::in_plane(axes(true)[0], axes(true)[1], axes(true)[2]);
    }
    return Vertex_condition_3::free();
  }

  // The point of the planes so far that is nearest to the start.
  struct Search
  {
    Vector point;
    std::vector<Vector> moves; // of the point, with any length; they are orthogonal to each other
    std::vector<std::set<std::size_t> > sources_of_moves;

    Vector part_without_moves(const Vector& n) const
    {
      Vector result = n;
      for(const Vector& d : moves)
        result = result - (n * d) / d.squared_length() * d;
      return result;
    }

    // the sine of the angle between a normal and the space of the moves
    double sine(const Vector& n) const
    { return std::sqrt(CGAL::to_double(Exact_rational(part_without_moves(n).squared_length() / n.squared_length()))); }

    bool is_met(const Plane& plane, const double tolerance) const
    {
      const Vector n = exact(plane.normal);
      return CGAL::square(Exact_rational(plane.offset - n * point))
             <= CGAL::square(Exact_rational(tolerance)) * n.squared_length();
    }

    void meet(const Plane& plane)
    {
      const Vector n = exact(plane.normal), move = part_without_moves(n);
      point = point + (plane.offset - n * point) / move.squared_length() * move;
      sources_of_moves.push_back(sources(plane));
      moves.push_back(move);
    }

    // the source of a plane, and those of the planes on which it depends
    std::set<std::size_t> sources(const Plane& plane) const
    {
      std::set<std::size_t> result = { plane.source };
      for(std::size_t i = 0; i < moves.size(); ++i)
        if(exact(plane.normal) * moves[i] != 0)
          result.insert(sources_of_moves[i].begin(), sources_of_moves[i].end());
      return result;
    }

    Vertex_condition_3 condition() const
    {
      if(moves.size() == 3)
        return Vertex_condition_3::at_target();
      const Vector d = moves.size() == 1 ? moves[0] : cross_product(moves[0], moves[1]);
      const auto [x, y, z] = rounded(d / (std::max)({ CGAL::abs(d.x()), CGAL::abs(d.y()), CGAL::abs(d.z()) }));
      return moves.size() == 1 ? Vertex_condition_3::in_plane(x, y, z) : Vertex_condition_3::on_line(x, y, z);
    }
  };

  static Point unit(const int axis) { return { double(axis == 0), double(axis == 1), double(axis == 2) }; }
  static Vector exact(const Point& p) { return Vector(p[0], p[1], p[2]); }

  // Returns the nearest doubles: the conversion of CGAL may truncate.
  static Point rounded(const Vector& v)
  {
    const auto nearest = [](const Exact_rational& x)
    {
      const double truncated = CGAL::to_double(x);
      return std::isfinite(truncated) ? truncated + CGAL::to_double(Exact_rational(x - truncated)) : truncated;
    };
    return { nearest(v.x()), nearest(v.y()), nearest(v.z()) };
  }

  Point m_start;
  double m_size;
  std::vector<Coordinate> m_coordinates;
  std::vector<Plane> m_planes; // those that are not orthogonal to an axis
  std::vector<Surface> m_surfaces; // and curves
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_MESH_PRESCRIBED_POSITION_3_H
