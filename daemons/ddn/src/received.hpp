// SPDX-License-Identifier: Apache-2.0
// Samples as inputs of a decision node.
#pragma once

#include <optional>
#include <string>

#include "skein/decision_node/messages.hpp"
#include "skein/node/node.hpp"

namespace skein::ddn {

/// The role of a sample's sender.
struct Sender {
  std::string name;
  bool ground = false;      ///< the ground station
  bool functional = false;  ///< this UAV's functional layer
};

/// The reason for refusing a sample of this sender; empty: accepted. Every node on the radio can
/// write to this one, but only the ground station may command it, only the functional layer may
/// report its vehicle, and other UAVs may report only about themselves.
std::string why_not(const wire::Sample& sample, const Sender& sender);

/// The input for a sample; absent for slots that a decision node does not read.
std::optional<decision_node::Input> input_of(const wire::Sample& sample, const Sender& sender);

}  // namespace skein::ddn
