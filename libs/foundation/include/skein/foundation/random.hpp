// SPDX-License-Identifier: Apache-2.0
// A seeded pseudo-random sequence, the same on every machine.
#pragma once

#include <cstdint>
#include <random>
#include <string_view>

namespace skein {

/// std::mt19937_64, whose sequence the C++ standard fixes, with own distributions, which the
/// standard does not fix. Each user is given a seed; there is no global generator.
/// Thread rule: not safe to share.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// An independent sequence for a named purpose: adding a consumer does not disturb the others.
  Random(std::uint64_t seed, std::string_view purpose);

  std::uint64_t bits() { return engine_(); }
  /// Uniform in [0, 1), 53 bits.
  double uniform();
  /// Uniform in [low, high); low <= high.
  double uniform(double low, double high);
  /// Uniform integer in [0, n); n > 0.
  std::uint64_t below(std::uint64_t n);
  bool chance(double probability) { return uniform() < probability; }
  /// Normal with mean 0 and standard deviation 1 (Box–Muller, cosine branch only).
  double normal();

 private:
  std::mt19937_64 engine_;
};

}  // namespace skein
