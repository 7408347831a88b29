// SPDX-License-Identifier: Apache-2.0
// Samples as inputs of a decision node.
#pragma once

#include <optional>
#include <string>

#include "skein/decision_node/messages.hpp"
#include "skein/node/node.hpp"

namespace skein::ddn {

/// Why a sample is not taken from its sender; empty: it is. Every node of the radio can write to
/// this one; who commands it and who tells of its vehicle is fixed.
std::string why_not(const node::Received& received, node::NodeNumber ground,
                    node::NodeNumber functional);

/// Absent for slots that a decision node does not read.
std::optional<decision_node::Input> input_of(const wire::Sample& sample);

}  // namespace skein::ddn
