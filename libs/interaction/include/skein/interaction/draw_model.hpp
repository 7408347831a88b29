// SPDX-License-Identifier: Apache-2.0
// Pictures of interaction models, as SVG.
#pragma once

#include <string>

#include "skein/interaction/automaton.hpp"
#include "skein/interaction/model.hpp"

namespace skein::interaction {

/// The variants of all models below each other, each with its roles beside each other: blocks
/// within blocks with their conditions, exits and local parameters, correspondences as arrows
/// between actions, and by colour where each SCM holds. Without models: each role alone.
std::string draw_svg(const Library& library);

/// One automaton.
std::string draw_svg(const Automaton& automaton, const std::string& title);

}  // namespace skein::interaction
