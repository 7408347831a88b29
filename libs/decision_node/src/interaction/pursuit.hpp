// SPDX-License-Identifier: Apache-2.0
// Following what moves, for a role.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "interaction/role_course.hpp"

namespace skein::decision_node {

/// The targets that a role follows, by componel: one flight after the other to beside where the
/// target is now. A target that nobody sees is waited for where it was.
class Pursuit {
 public:
  Pursuit(const PlaySurroundings& of, RoleCourse& course);

  /// Another role, or the same one once more: nothing is followed yet.
  void begin_anew() { following_.clear(); }
  /// Sets out for the target that the task of the componel names, and tells that it runs, or fails
  /// it.
  void follow(const std::string& componel);
  bool follows(const std::string& componel) const { return following_.contains(componel); }
  /// Flies on where a target has moved, after its position or the own one was seen.
  void look();
  /// The flight under way came to its end.
  void arrived(const std::string& componel) { following_.at(componel).flies = false; }
  void stop(const std::string& componel) { following_.erase(componel); }

 private:
  /// A target that is followed, and the place beside it.
  struct Following {
    std::string target;
    interaction::Position side{};     ///< horizontal offset from the target [m]
    interaction::Position seen_at{};  ///< the target's position at the last flight after it
    double height = 0;                ///< above the ground [m]
    bool flies = false;
  };

  /// Why there is no flight, if there is no way.
  std::optional<std::string> fly_after(const std::string& componel);

  JointHost& host_;
  const Sightings& sightings_;
  const Membership& my_;
  RoleCourse& course_;
  std::map<std::string, Following> following_;
};

}  // namespace skein::decision_node
