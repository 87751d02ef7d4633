// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
//
// This file is intended for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BUDGET_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BUDGET_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Real_timer.h>

#include <functional>
#include <limits>
#include <memory>
#include <utility>

namespace CGAL::Volume_mesh_parameterization::internal {

// What a computation may still take, by the clock and by its user; asked in each loop that may take long, by the thread
// that made it. Once exhausted, it remains so, and so do its copies, which are the same budget.
class Budget
{
public:
  explicit Budget(const double seconds = (std::numeric_limits<double>::infinity)(),
                  std::function<bool()> goes_on = [] { return true; })
    : m_seconds(seconds), m_goes_on(std::move(goes_on))
  {
    m_timer.start();
  }

  double seconds() const { return m_timer.time(); } // since the beginning

  bool is_exhausted() const
  {
    *m_is_exhausted = *m_is_exhausted || seconds() > m_seconds || !m_goes_on();
    return *m_is_exhausted;
  }

  void exhaust() { *m_is_exhausted = true; }

private:
  double m_seconds;
  std::function<bool()> m_goes_on;
  Real_timer m_timer;
  std::shared_ptr<bool> m_is_exhausted = std::make_shared<bool>(false);
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BUDGET_H
