// SPDX-License-Identifier: Apache-2.0
// The degrees of decisional autonomy, and which node has which function at each.
#pragma once

namespace skein::mission {

/// A degree of autonomy, 1 to 5. Source: T II.2, spec 1.2.
using Degree = int;

inline constexpr Degree kLeastDegree = 1;
inline constexpr Degree kGreatestDegree = 5;

/// True at degree 1: the ground runs the plan itself and the UAV's decision node only connects it
/// with the functional layer.
constexpr bool runs_at_ground(Degree degree) { return degree <= 1; }

/// True when a synchronisation message goes from MLE to MLE; else it goes through the ground, which
/// relays it (degree 2) or is one or both of the ends (degree 1).
constexpr bool synchronises_directly(Degree sender, Degree receiver) {
  return sender >= 3 && receiver >= 3;
}

/// True when missions are planned on board.
constexpr bool deliberates(Degree degree) { return degree >= 4; }

/// True when the UAV takes part in its team's auctions of tasks.
constexpr bool allocates(Degree degree) { return degree >= 5; }

}  // namespace skein::mission
