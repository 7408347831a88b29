// SPDX-License-Identifier: Apache-2.0
// Samples as somebody would send them who keeps to the wire types, but not to the truth.
#pragma once

#include <cstdint>
#include <deque>
#include <string>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/random.hpp"

namespace skein::testing {

/// Makes foul samples of fair ones: some fields have values that other fields had before, values at
/// the ends of their range, or others; some lists are longer, shorter or in another order. Headers
/// stay as they are.
class Fouler {
 public:
  explicit Fouler(std::uint64_t seed) : random_(seed) {}

  /// The sample with some of its fields changed; as it was if what came about would be dropped as
  /// malformed (wire::find_violation). Its names and numbers are used for later ones.
  wire::Sample foul(const wire::Sample& sample);

 private:
  class Gatherer;
  class Changer;

  Random random_;
  std::deque<std::uint64_t> numbers_;  ///< seen before, the latest
  std::deque<double> figures_;
  std::deque<std::string> names_;
};

}  // namespace skein::testing
