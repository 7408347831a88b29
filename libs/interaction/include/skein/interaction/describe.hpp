// SPDX-License-Identifier: Apache-2.0
// Conditions and constraints in words, for pictures and explanations.
#pragma once

#include <string>
#include <vector>

#include "skein/interaction/model.hpp"

namespace skein::interaction {

/// "t11 ended", "not message 'stop'", "900 s after t13 running".
std::string describe(const Literal& literal, const Automaton& automaton);
/// One line for each clause: "t11 ended or message 'go'", "and …"; with the effect for a loop's
/// exit.
std::vector<std::string> describe(const Formula& formula, const Automaton& automaton);
/// "endurance ≥ 900", "camera: visible", "hovering".
std::string describe(const Requirement& requirement);
/// "distance to p0 > 25 m", with the arguments of an instance.
std::vector<std::string> describe(const Scm& scm, const ScmInstance& instance);

}  // namespace skein::interaction
