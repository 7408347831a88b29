// SPDX-License-Identifier: Apache-2.0
// One function for each modality that is always there.
#pragma once

#include <memory>

#include "skein/negotiation/modality.hpp"

namespace skein::interaction {

/// Parameters: a row for each role, its name, numbers least and most (most < 0: any number). Offer:
/// a row for each role that the UAV can play, its name, number the cost (>= 0). Result: a row for
/// each member in order, its name, text the role, number the cost: the least sum that satisfies the
/// arities. Source: T V.3.2.
std::unique_ptr<NegotiationModality> role_allocation();

/// Parameters: `duration` [s] > 0, which an interval must last at least. Offer: rows `interval`,
/// best first, numbers from and until [s of mission time]. Result: one row `interval`: the times at
/// which all can, of the least sum of ranks, then of the least worst rank, then the earliest.
/// Source: T V.3.3.
std::unique_ptr<NegotiationModality> time_interval();

/// Parameters: rows `area`, the corners of a convex polygon each, x and y [m, ENU]. Offer: what
/// area_offer.hpp says. Result: for each area a row for each member in order, its name, numbers the
/// corners of its part, convex, such that all are done with theirs at about the same time as the
/// partition refiner reckons it over level ground without wind, in the end by what is flown where
/// that is given, areas one after the other; none for who is too far or too busy to be of help.
/// Source: annex B.
std::unique_ptr<NegotiationModality> area_sharing(FlownSweep flown);

/// For up to 8 members. Parameters: `directions`, how many there are around the target,
/// counter-clockwise from east (from as many as members to 72). Offer: rows `direction`, numbers
/// which one (from 0) and the cost (>= 0) of perceiving from there; those that will not do are left
/// out. Result: a row for each member in order, its name, number the direction: apart by the
/// greatest least angle, for the least sum of costs. Source: T V.3.4.
std::unique_ptr<NegotiationModality> perception_positions();

/// Parameters: rows `link`, one for each relay from the ground to the far end, numbers x, y and z
/// [m, ENU]. Offer: rows `link`, numbers which one (from 0) and the cost (>= 0) of standing there.
/// Result: a row for each member in order, its name, number its link, or -1: it is not needed.
/// Least sum of costs. Re-formed by a new session of those who are left. Source: T V.3.4.
std::unique_ptr<NegotiationModality> relay_chain();

}  // namespace skein::interaction
