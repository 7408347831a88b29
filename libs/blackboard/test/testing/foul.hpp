// SPDX-License-Identifier: Apache-2.0
// Samples as somebody would send them who keeps to the wire types, but not to the truth.
#pragma once

#include <cstdint>
#include <deque>
#include <string>

#include "skein/blackboard/wire.hpp"
#include "skein/foundation/random.hpp"

namespace skein::blackboard::testing {

/// Makes foul samples of fair ones: some fields have values that other fields had before, values at
/// the ends of their range, or others; some lists are longer, shorter or in another order.
class Fouler {
 public:
  enum class Changes { kAllButHeaders, kAll };

  explicit Fouler(std::uint64_t seed, Changes changes = Changes::kAllButHeaders)
      : random_(seed), changes_(changes) {}

  /// The sample with some of its fields changed; as it was if what came about would be dropped as
  /// malformed (wire::find_violation). Its names and numbers are used for later ones.
  wire::Sample foul(const wire::Sample& sample);

 private:
  class Gatherer;
  class Changer;

  Random random_;
  Changes changes_;
  std::deque<std::uint64_t> numbers_;  ///< seen before, the latest
  std::deque<double> figures_;
  std::deque<std::string> names_;
};

}  // namespace skein::blackboard::testing
