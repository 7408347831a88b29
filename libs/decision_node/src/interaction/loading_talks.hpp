// SPDX-License-Identifier: Apache-2.0
// What is negotiated before a joint task begins: who plays what, and when it starts.
#pragma once

#include <vector>

#include "interaction/joint_host.hpp"
#include "interaction/places.hpp"
#include "interaction/role_course.hpp"
#include "interaction/sightings.hpp"
#include "skein/negotiation/negotiation_manager.hpp"

namespace skein::decision_node {

inline constexpr const char* kRoles = "/roles";  ///< the subjects end so
inline constexpr const char* kStart = "/start";

interaction::BeginNegotiation roles_session(const Joint& joint);
interaction::BeginNegotiation start_session(const Joint& joint);

/// Of this UAV: it may start in these intervals, `ahead` later where that is still possible.
interaction::Rows offer_of_start(const std::vector<mission::Interval>& starts, Duration ahead);

/// This UAV, and from where it would begin.
struct RolePlayer {
  const JointHost& host;
  const Sightings& sightings;
  const Membership& my;
  const world::VehicleState& from;
  const Outlook& outlook;
};
/// What each role would cost it [s]; whoever takes another role while the joint task runs leaves
/// what it has under way. Refused: it can play none, and why.
Result<interaction::Rows, Failure> offer_of_roles(const interaction::Terms& terms,
                                                  const RolePlayer& player);

}  // namespace skein::decision_node
