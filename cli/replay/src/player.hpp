// SPDX-License-Identifier: Apache-2.0
// Playback position and speed of a replay.
#pragma once

#include <optional>
#include <string>

#include "skein/foundation/result.hpp"
#include "skein/foundation/time.hpp"

namespace skein::replay_tool {

/// A request of the page's playback bar; absent fields are unchanged.
struct Wish {
  std::optional<bool> playing;
  std::optional<double> speed;    ///< mission seconds per second, in [0.1, 1000]
  std::optional<MissionTime> at;  ///< go there
};

/// Of a request of the page: [{"playback": {"playing": true, "speed": 20, "at": 312.5}}]. Anything
/// else is refused with what was expected.
Result<Wish, Failure> wish_of(const std::string& actions);

class Player {
 public:
  /// Precondition: `speed` as in Wish.
  Player(MissionTime until, double speed) : until_(until), speed_(speed) {}

  /// Returns true if time went back, so that the page has to be cleared and filled again.
  bool carry_out(const Wish& wish);
  /// `passed`: of the steady clock. Halts at the end.
  void advance(Duration passed);

  MissionTime at() const { return at_; }
  double speed() const { return speed_; }
  bool playing() const { return playing_; }

 private:
  MissionTime until_, at_;
  double speed_;
  bool playing_ = true;
};

}  // namespace skein::replay_tool
