// SPDX-License-Identifier: Apache-2.0
// A role's nominal path, and which variant a team can play.
#pragma once

#include <string>
#include <vector>

#include "skein/interaction/model.hpp"

namespace skein::interaction {

/// A step of the nominal path: the tasks of a role if each ends successfully and there are no
/// messages, hence no contingencies and no negotiations. Each task comes at most once: the path
/// ends where a loop would repeat one.
struct NominalStep {
  std::string task;                   ///< id of the task
  std::vector<std::string> computed;  ///< local parameters computed since the previous step
};
/// The nominal path, in the order in which its tasks begin. Source: T V.3.2 ("chemin nominal").
std::vector<NominalStep> nominal_path(const Automaton& automaton);

/// The first variant whose arities permit `members` UAVs; null: none.
const Variant* variant_for(const Model& model, std::size_t members);

}  // namespace skein::interaction
