// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_BENCHMARK_FUZZ_RANDOM_H
#define T_SPLINES_BENCHMARK_FUZZ_RANDOM_H

#include <cmath>
#include <cstdint>
#include <random>

namespace fuzz {

/// Random numbers that are the same everywhere: the standard fixes the generator, but not its distributions.
class Random {
public:
  explicit Random(const std::uint64_t seed) : m_bits(seed) {}

  /// returns a number of [0, 1).
  double unit() { return static_cast<double>(m_bits() >> 11) * 0x1p-53; }
  /// returns a number of [low, high).
  double uniform(const double low, const double high) { return low + (high - low) * unit(); }
  /// returns a number of [low, high) whose logarithm is distributed evenly. \pre 0 < low <= high
  double log_uniform(const double low, const double high) { return low * std::pow(high / low, unit()); }
  /// returns a number of low, low + 1, ..., high.
  int integer(const int low, const int high) { return low + static_cast<int>((high - low + 1) * unit()); }
  /// returns whether an event of this probability happens.
  bool chance(const double probability) { return unit() < probability; }

private:
  std::mt19937_64 m_bits;
};

} // namespace fuzz

#endif // T_SPLINES_BENCHMARK_FUZZ_RANDOM_H
