// SPDX-License-Identifier: Apache-2.0
// Negotiations that assign a place to each member: directions around a target, links of a chain.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "interaction/places.hpp"
#include "skein/negotiation/modality.hpp"

namespace skein::decision_node {

/// True for the modalities perception-positions and relay-chain.
bool gives_places(std::string_view modality);

/// The terms of the negotiation, from the action's `in`: {around, distance, altitude, directions},
/// or {from, to, altitude} with one link between the two per member. Altitudes are above ground
/// [m]. Refused: a term is missing, or its place is unknown.
Result<interaction::Rows, Failure> place_terms(const interaction::CoordinationAction& action,
                                               const Arguments& scope, std::size_t members,
                                               const Outlook& outlook);

/// The offer of this UAV: flight time [s], on a straight line, to each place in free air. Refused:
/// the terms have no places, or none is in free air.
Result<interaction::Rows, Failure> offer_of_places(const interaction::Terms& terms,
                                                   const world::VehicleState& state,
                                                   const Outlook& outlook);

/// The place assigned to a member; nothing: none.
std::optional<interaction::Position> place_of_member(const std::string& member,
                                                     const interaction::Terms& terms,
                                                     const interaction::Rows& result,
                                                     const world::World& world);

}  // namespace skein::decision_node
