// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_VOLUME_FORM_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_VOLUME_FORM_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Mesh/Numbered_mesh_3.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Volume_mesh_parameterization::internal {

// Six times the volume of the image of a cell whose free vertices are among u and v is linear in u, v and u x v: the
// constant, and the three coefficients of each of them.
template <typename NT>
using Volume_form_3 = std::array<NT, 10>;

template <typename NT>
std::array<NT, 3> cross_product(const std::array<NT, 3>& a, const std::array<NT, 3>& b)
{
  return { NT(a[1] * b[2] - a[2] * b[1]), NT(a[2] * b[0] - a[0] * b[2]), NT(a[0] * b[1] - a[1] * b[0]) };
}

template <typename NT>
NT dot_product(const std::array<NT, 3>& a, const std::array<NT, 3>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Adds a multiple of a vector to the coefficients from `first` on.
template <typename NT>
void add_to_form(Volume_form_3<NT>& form, const int first, const int factor, const std::array<NT, 3>& vector)
{
  for(int k = 0; k < 3; ++k)
    form[first + k] += factor * vector[k];
}

// `point(v)` is the target of the prescribed vertex v. With the free vertices x and y, or x alone, in front of the others,
// which changes the sign with each exchange of two vertices, six times the volume is
//   det(y - x, p - x, q - x) = (y - x).(p x q) + (x x y).(q - p)
//   det(p - x, q - x, r - x) = p.(q x r) - x.(p x q + q x r + r x p).
template <typename NT, typename Point>
Volume_form_3<NT> volume_form_3(const Numbered_mesh_3& mesh, const std::array<int, 4>& cell, const int u, const Point& point)
{
  std::vector<int> free;
  std::vector<std::array<NT, 3> > p;
  int sign = 1;
  for(int i = 0; i < 4; ++i)
    if(mesh.is_free(cell[i]))
    {
      sign = p.size() % 2 == 0 ? sign : -sign;
      free.push_back(cell[i]);
    }
    else
      p.push_back(point(cell[i]));

  const auto begin_of = [u](const int v) { return v == u ? 1 : 4; };
  Volume_form_3<NT> form;
  form.fill(NT(0));
  if(free.size() == 2)
  {
    const std::array<NT, 3> normal = cross_product(p[0], p[1]);
    add_to_form(form, begin_of(free[0]), -sign, normal);
    add_to_form(form, begin_of(free[1]), sign, normal);
    const int sign_of_product = free[0] == u ? sign : -sign;
    add_to_form(form, 7, sign_of_product, p[1]);
    add_to_form(form, 7, -sign_of_product, p[0]);
    return form;
  }
  const std::array<NT, 3> normals[3] = { cross_product(p[1], p[2]), cross_product(p[2], p[0]), cross_product(p[0], p[1]) };
  form[0] = sign * dot_product(p[0], normals[0]);
  if(free.size() == 1)
    for(const std::array<NT, 3>& normal : normals)
      add_to_form(form, begin_of(free[0]), -sign, normal);
  else // without a free vertex, the last one takes the place of x, for which three exchanges bring it to the front
    form[0] = dot_product(p[3], normals[0]) + dot_product(p[3], normals[1]) + dot_product(p[3], normals[2]) - form[0];
  return form;
}

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INFEASIBILITY_VOLUME_FORM_3_H
