#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_MACHINE_PEAK_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_MACHINE_PEAK_H

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <utility>

// The processor time of this program in seconds: other programs on the machine do not count.
inline double processor_seconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// The shortest of a few calls of f, in seconds.
template <typename Function>
double shortest_seconds(const Function& f)
{
  double shortest = 1e300;
  for(int i = 0; i < 7; ++i)
  {
    const double begin = processor_seconds();
    f();
    shortest = (std::min)(shortest, processor_seconds() - begin);
  }
  return shortest;
}

// Fused multiplications and additions that do not wait for each other. The chains are listed by the
// template arguments 0, 1, ..., so that every compiler keeps them in registers.
template <std::size_t... chain>
double multiply_and_add(const int number_of_rounds, std::index_sequence<chain...>)
{
  using Packet = Eigen::internal::packet_traits<double>::type;
  const Packet factor = Eigen::internal::pset1<Packet>(0.5);
  Packet sums[] = {Eigen::internal::pset1<Packet>(chain)...};
  for(int i = 0; i < number_of_rounds; ++i)
    ((sums[chain] = Eigen::internal::pmadd(factor, factor, sums[chain])), ...);
  return (Eigen::internal::predux(sums[chain]) + ...);
}

// Operations per second of one thread.
inline double measure_peak_flops()
{
  constexpr int packet_size = Eigen::internal::packet_traits<double>::size;
  constexpr int number_of_chains = 12; // more than latency times throughput; they fit into sixteen registers
  using Chains = std::make_index_sequence<number_of_chains>;
  const int number_of_rounds = 10000000;
  volatile double sum = 0;
  const double seconds = shortest_seconds([&] { sum = multiply_and_add(number_of_rounds, Chains()); });
  return 2. * packet_size * number_of_chains * number_of_rounds / seconds;
}

// Bytes per second of one thread: a = b + 3 c, as in STREAM, on arrays that fit into no cache.
inline double measure_peak_bandwidth()
{
  const std::size_t n = std::size_t(1) << 25;
  Eigen::VectorXd a = Eigen::VectorXd::Zero(n), b = Eigen::VectorXd::Ones(n), c = Eigen::VectorXd::Ones(n);
  const double seconds = shortest_seconds([&] { a = b + 3 * c; });
  return a[n / 2] > 0 ? 3. * sizeof(double) * static_cast<double>(n) / seconds : 0;
}

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_MACHINE_PEAK_H
