// Copyright (c) 2026  the Volume_mesh_parameterization authors.
// All rights reserved.
// This file is intended for CGAL (www.cgal.org).
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Volume_mesh_parameterization authors

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_BUDGET_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_BUDGET_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/arguments.h>
#include <CGAL/Volume_mesh_parameterization/internal/Support/sentence.h>

#include <CGAL/Real_timer.h>

#include <functional>
#include <limits>
#include <memory>

namespace CGAL::Volume_mesh_parameterization::internal {

// Budget of a computation, limited by the clock and by the user. Each loop that may take long asks it, in the thread that made
// it. An exhausted budget remains so, and so do its copies, which are the same budget.
class Budget
{
public:
  explicit Budget(const double seconds = (std::numeric_limits<double>::infinity)(),
                  std::function<bool()> may_continue = [] { return true; },
                  std::function<bool(const Parameterization_step&)> after_step = [](const auto&) { return true; })
    : m_seconds(seconds), m_may_continue(std::move(may_continue)), m_after_step(std::move(after_step))
  { m_timer.start(); }

  double seconds() const { return m_timer.time(); } // time since the construction
  bool is_limited() const { return !std::isinf(m_seconds); } // by the clock

  bool is_exhausted() const
  {
    m_state->is_exhausted = m_state->is_exhausted || (is_limited() && seconds() > m_seconds) || !m_may_continue();
    return m_state->is_exhausted;
  }

  // Reports a round of a loop without Newton steps to the visitor, and returns whether it may begin.
  bool may_begin_round(const Phase phase, const char* name) const
  {
    if(is_exhausted())
      return false;
    Parameterization_step step;
    step.iteration = ++m_state->number_of_rounds;
    step.phase = phase;
    step.kind = Step_kind::ROUND;
    step.attempt = name;
    step.seconds = seconds();
    return report(step);
  }

  // Reports a step that was made elsewhere.
  bool report(const Parameterization_step& step) const
  {
    m_state->is_exhausted = m_state->is_exhausted || !m_after_step(step);
    return !m_state->is_exhausted;
  }

  void exhaust() { m_state->is_exhausted = true; }

  // Returns a budget of a part of the time that is left, which is exhausted with the whole one, too.
  Budget part(const double fraction) const
  {
    Budget result = *this;
    result.m_seconds = seconds() + fraction * (m_seconds - seconds());
    result.m_may_continue = [whole = *this] { return !whole.is_exhausted(); };
    result.m_after_step = [whole = *this](const Parameterization_step& step) { return whole.report(step); };
    result.m_state = std::make_shared<State>(State{ false, m_state->number_of_rounds });
    return result;
  }

  // Returns a budget of a part of the time that is left for a phase with a result at any time. Who ends the phase ends it alone.
  Budget of_phase(const Phase phase, const double fraction) const
  {
    Budget result = part(fraction);
    result.m_may_continue = m_may_continue;
    result.m_after_step = [after_step = m_after_step, phase](Parameterization_step step)
    {
      step.phase = phase;
      return after_step(step);
    };
    return result;
  }

private:
  struct State
  {
    bool is_exhausted = false;
    std::size_t number_of_rounds = 0;
  };

  double m_seconds;
  std::function<bool()> m_may_continue;
  std::function<bool(const Parameterization_step&)> m_after_step;
  Real_timer m_timer;
  std::shared_ptr<State> m_state = std::make_shared<State>();
};

// Type for a named parameter that will be modified: a copy if it was passed by value, a reference if by std::ref().
template <typename Reference>
using Mutable_parameter = std::conditional_t<
  std::is_const<std::remove_reference_t<Reference> >::value,
  std::remove_const_t<std::remove_reference_t<Reference> >,
  Reference>;

template <typename Visitor>
using Answer_between_steps = decltype(std::declval<Visitor&>().goes_on());

// Limits by the named parameters `visitor` and `maximum_running_time`, which end a computation early.
template <typename NamedParameters>
class Limits
{
public:
  explicit Limits(const NamedParameters& np)
    : m_visitor(parameters::choose_parameter(parameters::get_parameter_reference(np, internal_np::visitor), m_default)),
      m_seconds(parameter_or(np, internal_np::maximum_running_time, (std::numeric_limits<double>::infinity)()))
  { require(m_seconds >= 0, "maximum_running_time must not be negative."); }

  Limits(const Limits&) = delete;
  Limits& operator=(const Limits&) = delete;

  auto& visitor() { return m_visitor; }
  double seconds() const { return m_seconds; }

  // Returns a budget that begins now. A visitor need not have the function `goes_on()`.
  Budget budget()
  {
    const auto after_step = [this](const Parameterization_step& step) { return m_visitor.after_step(step); };
    if constexpr(boost::is_detected<Answer_between_steps, Visitor>::value)
      return Budget(m_seconds, [this] { return m_visitor.goes_on(); }, after_step);
    else
      return Budget(m_seconds, [] { return true; }, after_step);
  }

private:
  using Visitor = Mutable_parameter<typename internal_np::Lookup_named_param_def<
    internal_np::visitor_t, NamedParameters, Default_visitor>::reference>;
  static_assert(Is_visitor<Visitor>::value,
                "visitor must have a function bool after_step(const Parameterization_step&), which returns whether to go on.");

  Default_visitor m_default;
  Visitor m_visitor;
  double m_seconds;
};

} // namespace CGAL::Volume_mesh_parameterization::internal

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SUPPORT_BUDGET_H
