// SPDX-License-Identifier: Apache-2.0
// Whether the UAV is behind with a task of its team.
#pragma once

#include <optional>

#include "skein/foundation/time.hpp"

namespace skein::decision_node {

/// Compares the earliest end of the running task by its present plan with the latest end by its
/// first plan, so that no duration within the models' bounds counts. Each time it was behind, the
/// promise is renewed and the margin doubled, so that a task that never ends does not disturb the
/// team again and again. Source: spec 6.3; docs/decisions/0084-who-falls-behind-puts-back.md.
class Lateness {
 public:
  /// Behind by less is not behind.
  static constexpr Duration kMargin = Duration::milliseconds(20'000);

  /// Another task begins: there is no promise yet.
  void begun();
  /// Earliest and latest end of the task by its present plan; MissionTime::max(): not bounded.
  void planned(MissionTime earliest, MissionTime latest);
  /// By how much it is behind; none: by less than the margin.
  std::optional<Duration> behind(MissionTime now) const;
  /// Whether the team was told of this task.
  bool told() const { return margin_ > kMargin; }
  /// When it will be behind unless the task ends; none: there is no promise.
  std::optional<MissionTime> due() const;
  /// The team was told: from here on its present plan is the promise.
  void renew(MissionTime now);

 private:
  std::optional<MissionTime> promised_;
  MissionTime earliest_, latest_;
  Duration margin_ = kMargin;
};

}  // namespace skein::decision_node
