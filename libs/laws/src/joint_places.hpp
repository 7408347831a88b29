// SPDX-License-Identifier: Apache-2.0
// Where the constraints of a joint task allow a UAV to be, by truth.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "skein/laws/history.hpp"
#include "skein/laws/violation.hpp"

namespace skein::laws {

/// From when to when a UAV ran a joint task in one role.
struct Held {
  std::string uav, joint, role;
  double from = 0, until = kNever;
};
std::vector<Held> roles_held(const JointHistory& history);

/// The model of "model(a b c) of x, y" in the scenario's library; null: there is none.
const interaction::Model* model_of(const History& history, const std::string& joint);
/// Parameters of the variant by name: words of "model(a b c) of x, y", lists of UAVs left out.
std::map<std::string, std::string> arguments_of(const std::string& joint,
                                                const interaction::Variant& variant);

/// Constraints on a distance against a figure that the place does not keep, of those that it names;
/// what is known of partners is a little old. `slack` [m].
std::vector<Violation> distances_broken(const History& history, const PlaceTold& told,
                                        const interaction::Variant& variant, double slack);

}  // namespace skein::laws
