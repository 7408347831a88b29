// SPDX-License-Identifier: Apache-2.0
// Back-off: pauses that double.
#pragma once

#include <algorithm>

#include "skein/foundation/contract.hpp"
#include "skein/foundation/time.hpp"

namespace skein {

/// `first`, doubled `times` times, at most `most`. Precondition: 0 <= first <= most. Cost:
/// O(times), but no more than it takes to come to `most`. Pure.
constexpr Duration doubled(Duration first, int times, Duration most) {
  SKEIN_EXPECTS(first >= Duration() && first <= most);
  for (; times > 0 && first > Duration() && first < most; --times) first = first + first;
  return std::min(first, most);
}

/// What is repeated until it is answered, ever more rarely. A value.
struct Repeats {
  MissionTime last;  ///< when it was done last
  Duration pause;    ///< until it is done again

  MissionTime due() const { return last + pause; }
  bool is_due(MissionTime now) const { return due() <= now; }
  /// It was done again: the next pause is twice as long, at most `most`.
  void repeated(MissionTime now, Duration most) {
    last = now;
    pause = std::min(pause + pause, most);
  }
};

}  // namespace skein
