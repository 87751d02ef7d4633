// The loop of programs that run random inputs and check what is promised for any input.
#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_FUZZ_LOOP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_FUZZ_LOOP_H

#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>

inline std::uint64_t current_seed;

inline void expect(const bool condition, const std::string& promise)
{
  if(!condition)
    throw std::logic_error("broken promise: " + promise);
}

// A sanitizer, an assertion, or a computation without end.
inline void report_signal(const int signal)
{
  std::cerr << "seed " << current_seed << ": signal " << signal << std::endl;
  std::_Exit(1);
}

// Calls `run_input(seed)`, which returns how the run ended, as often as the first argument of a program says. The second one is
// the first seed. Input i is made from the seed SEED + i only, so a failure can be repeated by itself.
template <typename RunInput>
int run_inputs(const int argc, char* const argv[], const RunInput& run_input)
{
  const std::uint64_t number_of_inputs = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 200;
  const std::uint64_t first_seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 0;
  std::signal(SIGABRT, report_signal);
  std::signal(SIGALRM, report_signal);

  std::size_t number_of_failures = 0;
  std::map<std::string, std::size_t> endings;
  for(current_seed = first_seed; current_seed < first_seed + number_of_inputs; ++current_seed)
    try
    {
      alarm(300);
      ++endings[run_input(current_seed)];
    }
    catch(const std::exception& error)
    {
      ++number_of_failures;
      std::cerr << "seed " << current_seed << ": " << error.what() << std::endl;
    }
  for(const auto& [ending, number] : endings)
    std::cout << number << " times: " << ending << "\n";
  std::cout << number_of_failures << " failures" << std::endl;
  return number_of_failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TEST_FUZZ_LOOP_H
