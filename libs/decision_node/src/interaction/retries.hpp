// SPDX-License-Identifier: Apache-2.0
// When a joint task that could not be agreed on is negotiated again.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/world/volume.hpp"

namespace skein::decision_node {

/// On what a UAV's refusal of a role depends, as far as it can change by itself.
struct Circumstances {
  world::Vector3 place = world::Vector3::Zero();  ///< where the joint task begins [m]
  std::vector<world::Volume> closed;              ///< no-fly volumes
  std::vector<std::string> failed;                ///< devices

  bool is_as(const Circumstances& other, double near) const {
    return (place - other.place).norm() <= near && closed == other.closed && failed == other.failed;
  }
};

/// A failed negotiation is repeated each second at first, then more and more rarely up to every 20
/// s, and at once where the circumstances in which it failed have changed. Each member does so: one
/// whose circumstances change asks the others anew. A value.
class Retries {
 public:
  static constexpr Duration kOftenest = Duration::milliseconds(1'000);

  /// The negotiation failed for this reason; true: it is time to report it, true once for each. A
  /// reason that soon passes by itself, such as a partner that gets its mission a little later, is
  /// not reported.
  bool failed(const std::string& why, MissionTime now);
  /// The circumstances now. A place counts as the same within `near` [m].
  void see(Circumstances now_in, double near, MissionTime now);
  /// What is negotiated is another thing now: tried again after a second, and each second again.
  void anew(MissionTime now);

  /// When to negotiate again; absent: it is under negotiation, or agreed.
  std::optional<MissionTime> at() const { return at_; }
  void tried() { at_.reset(); }

 private:
  std::optional<MissionTime> at_;
  int in_a_row_ = 0;  ///< failed, in the same circumstances
  std::optional<Circumstances> in_;
  std::string why_;
  MissionTime since_;  ///< of `why_`
  bool said_ = false;
};

}  // namespace skein::decision_node
