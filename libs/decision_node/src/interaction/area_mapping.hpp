// SPDX-License-Identifier: Apache-2.0
// Mapping the own part of a shared area, for a role.
#pragma once

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
  /// on; tells that it has ended if nothing is left.
  void map(const std::string& componel);
  /// Notes what was seen on the way to the present position. Precondition: that is known.
  void see();

 private:
  SweepSetting setting(const std::string& role) const;

  JointHost& host_;
  const Sightings& sightings_;
  const Membership& my_;
  RoleCourse& course_;
  AreaShare share_;
};

}  // namespace skein::decision_node
