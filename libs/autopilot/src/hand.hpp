// SPDX-License-Identifier: Apache-2.0
// Who has the vehicle: this bridge, or the pilot and the autopilot's own safety.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "picture.hpp"

namespace skein::autopilot {

/// | the vehicle is | it is in the hand of |
/// | disarmed | nobody: tasks may begin |
/// | armed in a mode that was asked for, or within 3 s after that in one that was allowed before |
/// ours | | armed with the pilot's sticks counting (PX4) | the pilot's | | armed in another mode |
/// the pilot's, or its own failsafe's | | and then in the guided mode | ours again |
///
/// At first the guided mode counts as asked for: the bridge may have been restarted in mid-flight.
class Hand {
 public:
  /// A command that leads to these modes is about to be sent.
  void ask_for(std::vector<CustomMode> modes, Duration now);
  /// True when it has just been taken out of ours.
  bool look_at(const Picture& picture, Duration now);
  /// In whose hands and why; absent while it is ours or nobody's.
  const std::optional<std::string>& taken() const { return taken_; }

 private:
  bool may_be_in(CustomMode mode, Duration now) const;

  std::vector<CustomMode> asked_, before_;
  Duration asked_at_{};
  std::optional<std::string> taken_;
};

}  // namespace skein::autopilot
