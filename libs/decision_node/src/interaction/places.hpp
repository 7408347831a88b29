// SPDX-License-Identifier: Apache-2.0
// Places computed for the local parameters of roles, and the cost of a role.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "interaction/joint.hpp"
#include "skein/interaction/valid_position.hpp"
#include "skein/negotiation/role_places.hpp"
#include "skein/supervisor/planning.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::decision_node {

/// The input of a search for places.
struct Outlook {
  const supervisor::Knowledge& knowledge;
  const world::World& world;
  interaction::Observer observer;
  MissionTime now;
  /// Whether the UAV could stay at a place beside the reservations of others; empty: anywhere.
  std::function<bool(const world::Vector3&)> free_to_stay = {};
  interaction::RefusedViews* refused = nullptr;  ///< views that there are not; absent: unknown
};

/// A parsed initialiser, such as "best-view(front, center)".
struct Call {
  std::string function;
  std::vector<std::string> arguments;
};
Call call_of(const std::string& initialiser);

/// The value of a call that yields a text: "whole-area(area)" yields the area's name. Nothing: the
/// call yields no text, or its argument has no value.
std::optional<Argument> text_of(const Call& call, const interaction::Library& library,
                                const Arguments& scope);

/// The question where a role is to go.
struct PlaceQuery {
  Call call;
  Arguments scope;               ///< values of the names in the call
  interaction::Position from{};  ///< present or future position of the UAV
  std::string device;            ///< the role's sensor; empty: none
  std::vector<interaction::ActiveScm> scms;
};

/// A place that satisfies the SCMs whose places are known (those that involve a partner that is not
/// heard cannot be kept). Prefers places free of others' reservations. Refused: unknown function,
/// unknown place, no place found. Cost: docs/performance.md.
Result<interaction::Position, Failure> place_of(const PlaceQuery& query, const Outlook& outlook);

/// The position flown to for a name or a point: above a named place at the usual height, a point
/// as given.
Result<interaction::Position, Failure> aim_of(const Argument& argument, const Outlook& outlook);

/// The vehicle's sensor for a role: the one that the role needs, otherwise the first.
std::string device_of(const interaction::Role& role, const world::VehicleModel& vehicle);

/// The SCMs of the variant that hold in some block of the role and satisfy `counts`.
std::vector<interaction::ActiveScm> scms_of(
    const Joint& joint, const std::string& role, const Holders& holders, const std::string& self,
    const std::function<bool(const interaction::ScmInstance&, const std::vector<std::string>&)>&
        counts);

/// The time and energy of a role if all goes well.
struct RoleCost {
  double seconds = 0;
  double energy = 0;  ///< as a fraction of the full capacity
};

/// The cost of a role from `state`; or why the UAV cannot play it: a missing device, no place.
Result<RoleCost, Failure> cost_of(const Joint& joint, const std::string& role,
                                  const world::VehicleState& state, const Outlook& outlook);
/// Why a vehicle can play none of the roles, now or later: what it lacks; empty: it can play one.
std::string no_role_for(const Joint& joint, const world::VehicleModel& vehicle,
                        const world::VehicleState& state);

}  // namespace skein::decision_node
