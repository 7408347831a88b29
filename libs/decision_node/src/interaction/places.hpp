// SPDX-License-Identifier: Apache-2.0
// What local parameters of roles are computed to be, and what a role costs.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "interaction/joint.hpp"
#include "skein/interaction/valid_position.hpp"
#include "skein/supervisor/planning.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::decision_node {

/// What places are looked for from.
struct Outlook {
  const supervisor::Knowledge& knowledge;
  const world::World& world;
  interaction::Observer observer;
  MissionTime now;
  /// Where it could stay beside others that merge their ways with it; none: anywhere.
  std::function<bool(const world::Vector3&)> free_to_stay = {};
};

/// "best-view(front, center)" taken apart.
struct Call {
  std::string function;
  std::vector<std::string> arguments;
};
Call call_of(const std::string& initialiser);

/// The value of a call that gives a text: "whole-area(area)" is the area that it names. Nothing: it
/// gives no text, or its argument has no value.
std::optional<Argument> text_of(const Call& call, const interaction::Library& library,
                                const Arguments& scope);

/// Where a role is to go.
struct PlaceQuery {
  Call call;
  Arguments scope;               ///< what the names of the call stand for
  interaction::Position from{};  ///< where the UAV is, or will be
  std::string device;            ///< that the role perceives with; empty: none
  std::vector<interaction::ActiveScm> scms;
};

/// Under the SCMs whose places are known: of a partner that nobody hears of nothing can be kept.
/// Where others leave it no air to stay in, only if there is no other place.
/// Refused: no such function, an unknown place, none found. Cost: docs/performance.md.
Result<interaction::Position, Failure> place_of(const PlaceQuery& query, const Outlook& outlook);

/// Where a name or a point is flown to: over a place at the usual height, to a point as it is.
Result<interaction::Position, Failure> aim_of(const Argument& argument, const Outlook& outlook);

/// The device of the vehicle that a role perceives with: the one that it needs, or else the first.
std::string device_of(const interaction::Role& role, const world::VehicleModel& vehicle);

/// SCMs of the variant that hold in some block of the role, of which `counts` says yes.
std::vector<interaction::ActiveScm> scms_of(
    const Joint& joint, const std::string& role, const Holders& holders, const std::string& self,
    const std::function<bool(const interaction::ScmInstance&, const std::vector<std::string>&)>&
        counts);

/// What a role takes if all goes well.
struct RoleCost {
  double seconds = 0;
  double energy = 0;  ///< as a fraction of what is held when full
};

/// From where the UAV is; or why it cannot play it: what it lacks, no place for it.
Result<RoleCost, Failure> cost_of(const Joint& joint, const std::string& role,
                                  const world::VehicleState& state, const Outlook& outlook);

}  // namespace skein::decision_node
