// SPDX-License-Identifier: Apache-2.0
// The standard modalities.
#pragma once

#include <memory>

#include "skein/negotiation/modality.hpp"

namespace skein::interaction {

/// Parameters: a row for each role, its name, numbers least and most (most < 0: any number). Offer:
/// a row for each role that the UAV can play, its name, number the cost (>= 0). Result: a row for
/// each member in order, its name, text the role, number the cost: the least sum that satisfies the
/// arities. Source: T V.3.2.
std::unique_ptr<NegotiationModality> role_allocation();

/// Parameters: `duration` [s] > 0, the least length of an interval. Offer: rows `interval`, best
/// first, numbers from and until [s of mission time]. Result: one row `interval`: the common part
/// of one interval of each member, with the least sum of ranks, then the least worst rank, then the
/// earliest. Source: T V.3.3.
std::unique_ptr<NegotiationModality> time_interval();

/// Parameters: rows `area`, each with the corners of a convex polygon, x and y [m, ENU]. Offer: see
/// area_offer.hpp. Result: for each area, one area after the other, a row for each member in order:
/// its name, numbers the corners of its convex part. All members finish their parts at about the
/// same time, by the partition refiner's estimates over level ground without wind, corrected by
/// `flown` if it is given. A member too far or too busy to be of help gets no part. Source: annex
/// B.
std::unique_ptr<NegotiationModality> area_sharing(FlownSweep flown);

/// For up to 8 members. Parameters: `directions`, the number of directions around the target,
/// counter-clockwise from east (from the number of members to 72). Offer: rows `direction`, numbers
/// its index (from 0) and the cost (>= 0) of perceiving from there; impossible directions are left
/// out. Result: a row for each member in order, its name, number the direction: the least angle
/// between two members is greatest, then the sum of costs least. Source: T V.3.4.
std::unique_ptr<NegotiationModality> perception_positions();

/// Parameters: rows `link`, one for each relay place from the ground to the far end, numbers x, y
/// and z [m, ENU]. Offer: rows `link`, numbers its index (from 0) and the cost (>= 0) of staying
/// there. Result: a row for each member in order, its name, number its link, or -1 if it is not
/// needed; of the least sum of costs. If members drop out, the others negotiate a new session.
/// Source: T V.3.4.
std::unique_ptr<NegotiationModality> relay_chain();

}  // namespace skein::interaction
