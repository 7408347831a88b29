// SPDX-License-Identifier: Apache-2.0
// How long a refiner may search.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>

namespace skein::refiners {

/// Two bounds: a count of steps, by which the same query gives the same answer everywhere, and the
/// host's clock, which is asked now and then and wins. A search that the clock cuts gives the best
/// it has and says so (Effort::cut_short). A value type.
struct Budget {
  /// True once the time is up. May be empty: never. Called from the thread of the service, every
  /// few thousand elementary operations (some 50 µs).
  std::function<bool()> time_is_up;
  /// Elementary steps of the service that is asked (expansions, moves tried, …: each says which).
  std::uint64_t steps = std::numeric_limits<std::uint64_t>::max();

  bool expired() const { return time_is_up && time_is_up(); }
};

/// Asks the clock of a budget only every `stride` steps, since asking costs more than a step.
/// Thread rule: one thread.
class Countdown {
 public:
  explicit Countdown(const Budget& budget, std::uint32_t stride = 1024)
      : budget_(budget), stride_(stride) {}
  /// Counts one step; false once either bound is reached, and from then on.
  bool step() {
    if (over_) return false;
    ++steps_;
    over_ = steps_ > budget_.steps || (steps_ % stride_ == 0 && out_of_time());
    return !over_;
  }
  std::uint64_t steps() const { return steps_; }
  bool over() const { return over_; }
  /// True when it was the clock that ended it, so that another run may end elsewhere.
  bool cut_short() const { return cut_short_; }

 private:
  bool out_of_time() { return cut_short_ = budget_.expired(); }

  const Budget& budget_;
  std::uint32_t stride_;
  std::uint64_t steps_ = 0;
  bool over_ = false, cut_short_ = false;
};

}  // namespace skein::refiners
