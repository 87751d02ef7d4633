#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_COUNTING_NUMBER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_COUNTING_NUMBER_H

#include <Eigen/Core>

#include <cmath>
#include <cstddef>

// A number that counts the operations on it: +, -, *, /, square root, exponential and logarithm are
// one each; comparisons, selections and signs are none.
class Counting_number
{
public:
  Counting_number() = default;
  Counting_number(const double x) : m_value(x) {}

  static std::size_t& count()
  {
    static std::size_t n = 0;
    return n;
  }

  friend Counting_number operator+(Counting_number a, Counting_number b) { return counted(a.m_value + b.m_value); }
  friend Counting_number operator-(Counting_number a, Counting_number b) { return counted(a.m_value - b.m_value); }
  friend Counting_number operator*(Counting_number a, Counting_number b) { return counted(a.m_value * b.m_value); }
  friend Counting_number operator/(Counting_number a, Counting_number b) { return counted(a.m_value / b.m_value); }
  friend Counting_number operator-(Counting_number a) { return -a.m_value; }
  Counting_number& operator+=(Counting_number b) { return *this = *this + b; }
  Counting_number& operator-=(Counting_number b) { return *this = *this - b; }
  Counting_number& operator*=(Counting_number b) { return *this = *this * b; }
  Counting_number& operator/=(Counting_number b) { return *this = *this / b; }

  friend Counting_number sqrt(Counting_number a) { return counted(std::sqrt(a.m_value)); }
  friend Counting_number exp(Counting_number a) { return counted(std::exp(a.m_value)); }
  friend Counting_number log(Counting_number a) { return counted(std::log(a.m_value)); }
  friend Counting_number abs(Counting_number a) { return std::abs(a.m_value); }

  friend bool operator<(Counting_number a, Counting_number b) { return a.m_value < b.m_value; }
  friend bool operator<=(Counting_number a, Counting_number b) { return a.m_value <= b.m_value; }
  friend bool operator>(Counting_number a, Counting_number b) { return a.m_value > b.m_value; }
  friend bool operator>=(Counting_number a, Counting_number b) { return a.m_value >= b.m_value; }
  friend Counting_number minimum(Counting_number a, Counting_number b) { return b < a ? b : a; }
  friend Counting_number maximum(Counting_number a, Counting_number b) { return a < b ? b : a; }
  friend Counting_number select(bool mask, Counting_number a, Counting_number b) { return mask ? a : b; }

private:
  static Counting_number counted(const double x)
  {
    ++count();
    return x;
  }

  double m_value = 0;
};

// The number of operations of a call of f.
template <typename Function>
std::size_t count_operations(const Function& f)
{
  Counting_number::count() = 0;
  f();
  return Counting_number::count();
}

namespace Eigen {

template <>
struct NumTraits<Counting_number> : GenericNumTraits<Counting_number>
{
  using Real = Counting_number;
  using NonInteger = Counting_number;
  using Nested = Counting_number;
  using Literal = Counting_number;

  enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1,
         ReadCost = 1, AddCost = 1, MulCost = 1 };
};

} // namespace Eigen

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BENCHMARK_COUNTING_NUMBER_H
