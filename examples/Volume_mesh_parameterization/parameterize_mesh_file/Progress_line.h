#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_PROGRESS_LINE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_PROGRESS_LINE_H

#include <CGAL/Real_timer.h>
#include <CGAL/Volume_mesh_parameterization/IO/Output_file.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_parameters.h>

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

// Exception that ends the program before there is a map. The sentence says what is missing.
struct Interruption
{
  std::string sentence = "There is no map yet.";
};

// Keeps one line of a terminal up to date, and ends each computation that it visits when the time since its construction is
// over, or when the user (Ctrl-C, or a terminal that is closed) or the system (SIGTERM) asks to end. A second request ends
// the program.
class Progress_line
{
public:
  Progress_line(const bool is_shown, const double time_limit)
    : m_is_shown(is_shown && isatty(STDERR_FILENO) != 0), m_time_limit(time_limit)
  {
    m_timer.start();
    signal(SIGPIPE, SIG_IGN); // a reader that goes away is an error with a sentence,
    signal(SIGXFSZ, SIG_IGN); // and so is a limit of the size of files
    struct sigaction action = {};
    action.sa_handler = request_end;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    struct sigaction before = {};
    sigaction(SIGHUP, nullptr, &before);
    if(before.sa_handler != SIG_IGN) // nohup
      sigaction(SIGHUP, &action, nullptr);
  }

  // Says what comes next, unless it should not be begun.
  void begin(const std::string& text) const
  {
    if(!goes_on())
      throw Interruption();
    show(text);
  }

  void show(const std::string& text) const
  {
    m_text = text;
    m_seconds_of_text = seconds();
    if(m_is_shown)
      std::cerr << "\r\033[K" << text << std::flush;
  }

  // Is asked again and again, and shows the time where nothing else moves.
  bool goes_on() const
  {
    const double time = seconds();
    if(m_is_shown && !m_text.empty() && time > (std::max)(m_seconds_of_text, m_seconds_of_time) + 0.5)
    {
      m_seconds_of_time = time;
      std::cerr << "\r\033[K" << m_text << ", " << std::lround(time) << " s" << std::flush;
    }
    if(is_end_requested != 0 && m_phase == VMP::Phase::SPLITS) // which end alone
    {
      is_end_requested = 0;
      return false;
    }
    return is_end_requested == 0 && time < m_time_limit;
  }

  double seconds() const { return m_timer.time(); } // since the beginning of the program

  // Returns the limit for the computations that follow.
  double seconds_left() const { return (std::max)(0., m_time_limit - seconds()); }

  bool after_step(const VMP::Parameterization_step& step)
  {
    m_phase = step.phase;
    std::ostringstream text;
    if(step.kind == VMP::Step_kind::ROUND)
    {
      text << (step.phase == VMP::Phase::HEXAHEDRA ? "making hexahedra" : "mapping the boundary") << " (" << step.attempt
           << "), round " << step.iteration;
      show(text.str());
      return goes_on();
    }
    m_steps.push_back(step);
    text << (step.phase == VMP::Phase::UNTANGLING ? "untangling" : "minimizing") << " (" << step.attempt << "), step "
         << step.iteration << ", " << step.number_of_inverted_cells << " inverted cells";
    if(step.kind == VMP::Step_kind::NEWTON)
      text << ", energy " << step.energy;
    show(text.str());
    return goes_on();
  }

  // Returns the reason for which the computation was ended.
  static const char* reason()
  {
    return is_interrupted != 0 ? "Interrupted." : "The time limit was reached.";
  }

  void finish() const { show(""); }

  const std::vector<VMP::Parameterization_step>& steps() const { return m_steps; }

private:
  // The second time, the default action follows.
  static void request_end(const int number)
  {
    if(is_end_requested != 0)
    {
      VMP::IO::Output_file::remove_unfinished();
      signal(number, SIG_DFL);
      raise(number);
    }
    is_end_requested = is_interrupted = 1;
  }

  static inline volatile sig_atomic_t is_end_requested = 0, is_interrupted = 0;

  bool m_is_shown;
  VMP::Phase m_phase = VMP::Phase::START; // of the last step
  mutable std::string m_text;
  mutable double m_seconds_of_text = 0, m_seconds_of_time = 0; // when it was shown first, and the time after it last
  double m_time_limit; // in seconds, from the beginning of the program
  CGAL::Real_timer m_timer;
  std::vector<VMP::Parameterization_step> m_steps;
};

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_EXAMPLES_PROGRESS_LINE_H
