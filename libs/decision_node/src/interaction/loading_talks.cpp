// SPDX-License-Identifier: Apache-2.0
#include "interaction/loading_talks.hpp"

#include <algorithm>

#include "interaction/loading_time.hpp"
#include "skein/foundation/joined.hpp"

namespace skein::decision_node {

namespace {

constexpr Duration kSession = Duration::milliseconds(30'000);
constexpr double kRoom = 1;    // [s] at the end of an interval
constexpr double kChange = 4;  // [s] all meet anew

/// Why a role cannot be played by who has these devices no more; empty: it needs none of them.
std::string lacking(const interaction::Role& role, const std::vector<std::string>& failed) {
  for (const interaction::Requirement& one : role.requirements) {
    const auto* device = std::get_if<std::string>(&one.value);
    if (device != nullptr && std::find(failed.begin(), failed.end(), *device) != failed.end())
      return "device '" + *device + "' has failed";
  }
  return {};
}

double cost_of_change(const Membership& my, const std::string& self, const std::string& role) {
  const auto held = my.holders.find(self);
  const bool runs = my.phase == interaction::JointPhase::kRunning && held != my.holders.end();
  return runs && held->second != role ? kChange : 0;
}

/// What it takes to play a role, and to change to it [s]. Refused: it cannot.
Result<double, Failure> cost_of_role(const std::string& role, const RolePlayer& player) {
  const Joint& joint = player.my.joint;
  std::string why = player.host.why_not(joint, role);
  if (why.empty()) why = lacking(joint.library->roles.at(role), player.sightings.own()->failed);
  if (!why.empty()) return failure(std::move(why));
  const auto cost = cost_of(joint, role, player.from, player.outlook);
  if (!cost) return tl::unexpected(cost.error());
  return cost->seconds + cost_of_change(player.my, player.host.config().uav, role);
}

}  // namespace

interaction::BeginNegotiation roles_session(const Joint& joint) {
  interaction::BeginNegotiation begin;
  begin.subject = joint.subject + kRoles;
  begin.modality = "role-allocation";
  for (const std::string& role : joint.variant->roles) {
    const interaction::Arity& arity = joint.variant->table.arities.at(role);
    begin.parameters.push_back(
        {role, "", {double(arity.least), arity.most ? double(*arity.most) : -1}});
  }
  begin.within = kSession;
  return begin;
}

interaction::BeginNegotiation start_session(const Joint& joint) {
  interaction::BeginNegotiation begin;
  begin.subject = joint.subject + kStart;
  begin.modality = "time-interval";
  begin.parameters = {{"duration", "", {kRoom / 2}}};
  begin.within = kSession;
  return begin;
}

interaction::Rows offer_of_start(const std::vector<mission::Interval>& starts, Duration ahead) {
  interaction::Rows rows;
  for (const mission::Interval& one : starts) {
    const double until = std::min(one.most.to_seconds(), LoadingTime::kForever);
    const double from = std::clamp((one.least + ahead).to_seconds(), one.least.to_seconds(),
                                   std::max(one.least.to_seconds(), until));
    rows.push_back({"interval", "", {from, std::max(from, until) + kRoom}});
  }
  return rows;
}

Result<interaction::Rows, Failure> offer_of_roles(const interaction::Terms& terms,
                                                  const RolePlayer& player) {
  const Joint& joint = player.my.joint;
  interaction::Rows rows;
  std::vector<std::string> reasons;
  for (const interaction::Row& role : terms.parameters) {
    if (!joint.library->roles.contains(role.name)) return failure("no role '" + role.name + "'");
    const auto cost = cost_of_role(role.name, player);
    if (cost) {
      rows.push_back({role.name, "", {*cost}});
    } else {
      rows.push_back({role.name, cost.error().why, {}});
      reasons.push_back(role.name + ": " + cost.error().why);
    }
  }
  if (reasons.size() == rows.size())
    return failure("it can play no role: " + joined(reasons, "; "));
  return rows;
}

}  // namespace skein::decision_node
