// SPDX-License-Identifier: Apache-2.0
// Samples as inputs of a decision node.
#pragma once

#include <optional>
#include <string>

#include "skein/decision_node/messages.hpp"
#include "skein/node/node.hpp"

namespace skein::ddn {

/// Who a sample comes from.
struct Sender {
  std::string name;
  bool ground = false;      ///< the ground station
  bool functional = false;  ///< this UAV's functional layer
};

/// Why a sample is not taken from its sender; empty: it is. Every node of the radio can write to
/// this one; who commands it and who tells of its vehicle is fixed, and what other UAVs tell of
/// themselves they tell themselves.
std::string why_not(const wire::Sample& sample, const Sender& sender);

/// Absent for slots that a decision node does not read.
std::optional<decision_node::Input> input_of(const wire::Sample& sample, const Sender& sender);

}  // namespace skein::ddn
