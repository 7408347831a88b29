// SPDX-License-Identifier: Apache-2.0
// Mapping the own part of a shared area, for a role.
#pragma once

#include <set>
#include <string>

#include "interaction/area_share.hpp"
#include "interaction/role_course.hpp"

namespace skein::decision_node {

class AreaMapping {
 public:
  AreaMapping(const PlaySurroundings& of, RoleCourse& course);

  AreaShare& share() { return share_; }
  const AreaShare& share() const { return share_; }
  /// What this UAV can map, for the division of the area. Precondition: it holds a role.
  Result<interaction::Rows, Failure> offer(const interaction::Terms& terms) const;
  /// The flights over what is left of the own part, for the task of the componel, with its device
  /// on; tells that it has ended if nothing is left. Where air that is closed for a time leaves no
  /// way, a wait until the next is open: then it is to be asked again.
  void map(const std::string& componel);
  /// A task given for that has ended. Whether there is more to be asked for.
  bool goes_on_after(executive::TaskId task);
  /// Notes what was seen on the way to the present position. Precondition: that is known.
  void see();

 private:
  void wait(const std::string& componel, const supervisor::NoSweep& refused);
  SweepSetting setting(const std::string& role) const;

  JointHost& host_;
  const Sightings& sightings_;
  const Membership& my_;
  RoleCourse& course_;
  AreaShare share_;
  std::set<executive::TaskId> waits_;
};

}  // namespace skein::decision_node
