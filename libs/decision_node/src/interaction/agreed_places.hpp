// SPDX-License-Identifier: Apache-2.0
// Negotiations whose result is a place for each member: directions around a target, links of a
// chain.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "interaction/places.hpp"
#include "skein/negotiation/modality.hpp"

namespace skein::decision_node {

/// perception-positions, relay-chain.
bool gives_places(std::string_view modality);

/// What is negotiated, as the action's `in` says: {around, distance, altitude, directions}, or
/// {from, to, altitude} with as many links between the two as there are members. Altitudes are over
/// the ground [m]. Refused: one of them is missing, or nobody knows where it is.
Result<interaction::Rows, Failure> place_terms(const interaction::CoordinationAction& action,
                                               const Arguments& scope, std::size_t members,
                                               const Outlook& outlook);

/// Seconds of a straight flight to each place that is in free air. Refused: terms that say no
/// places, or none of them is.
Result<interaction::Rows, Failure> offer_of_places(const interaction::Terms& terms,
                                                   const world::VehicleState& state,
                                                   const Outlook& outlook);

/// Where a member is to go; nothing: it is not needed.
std::optional<interaction::Position> place_of_member(const std::string& member,
                                                     const interaction::Terms& terms,
                                                     const interaction::Rows& result,
                                                     const world::World& world);

}  // namespace skein::decision_node
