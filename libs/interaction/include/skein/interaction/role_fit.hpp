// SPDX-License-Identifier: Apache-2.0
// Who can play a role, what it amounts to if all goes well, and which variant a team can play.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "skein/interaction/model.hpp"

namespace skein::interaction {

/// What a UAV has of one capability: values (`camera: visible`, `camera: ir`), a figure
/// (`endurance`), or nothing but that it has it.
struct Capability {
  std::set<std::string> values;
  std::optional<double> figure;
};
using Capabilities = std::map<std::string, Capability>;

/// The requirements of a role that are not met, all of them. Source: T def. V.1, V.3.2.
std::vector<Requirement> unmet(const Role& role, const Capabilities& capabilities);

/// What a role does as long as everything ends well and nothing but that happens: no messages, so
/// no contingencies and no negotiation. Each task at most once: where a loop would begin the same
/// again the path is over.
struct NominalStep {
  std::string task;                   ///< its id
  std::vector<std::string> computed;  ///< local parameters computed since the step before
};
/// In the order in which they are begun. Source: T V.3.2 ("chemin nominal").
std::vector<NominalStep> nominal_path(const Automaton& automaton);

/// The first variant that so many UAVs can play by its arities; null: none.
const Variant* variant_for(const Model& model, std::size_t members);

}  // namespace skein::interaction
