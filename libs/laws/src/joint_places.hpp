// SPDX-License-Identifier: Apache-2.0
// Whether positions of UAVs satisfy the spatial constraints of their joint tasks, by truth.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "checks.hpp"
#include "skein/laws/history.hpp"
#include "skein/laws/violation.hpp"

namespace skein::laws {

/// The time during which a UAV ran a joint task in one role [s].
struct Held {
  std::string uav, joint, role;
  double from = 0, until = kNever;
};
std::vector<Held> roles_held(const JointHistory& history);

/// The model named by "model(a b c) of x, y" in the scenario's library; null: there is none.
const interaction::Model* model_of(const History& history, const std::string& joint);
/// The variant in which this UAV was in a joint task; null: the library has no such one.
const interaction::Variant* variant_of(const History& history, const JointTold& told);
/// The areas that members of the variant share: parameters of the model that an action of area
/// sharing names.
std::set<std::string> shared_areas(const History& history, const interaction::Variant& variant);
/// Parameters of the variant by name: words of "model(a b c) of x, y", lists of UAVs left out.
std::map<std::string, std::string> arguments_of(const std::string& joint,
                                                const interaction::Variant& variant);

/// What members looked at for a joint task.
std::vector<Look> looks_for(const History& history, const std::string& joint);

/// Where a UAV or a place is in truth, or for all that `uav` may know at that instant; what was
/// given under the ground is on it. Absent: nobody can say, or it is being told.
std::optional<world::Vector3> where(const History& history, const std::string& name,
                                    const std::string& uav, double at);

/// Violations of constraints between a distance and a number, among those that `told` names, at its
/// position. `slack`: tolerance, since known positions of partners are a little old [m].
std::vector<Violation> distances_broken(const History& history, const PlaceTold& told,
                                        const interaction::Variant& variant, double slack);

}  // namespace skein::laws
