// SPDX-License-Identifier: Apache-2.0
// An elementary task as it is handed to the executive, and the states it goes through.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/executive/condition.hpp"
#include "skein/executive/task_state.hpp"
#include "skein/foundation/time.hpp"
#include "skein/functional/parameters.hpp"

namespace skein::executive {

/// Parameters are for the functional layer. The executive reads only those that name a device, for
/// its resource (spec 2.5).
using functional::Parameter;
using functional::Parameters;

/// The synchronisation that a task (`synchronise`, `rendezvous`) carries out. A UAV among the
/// senders sends one message to each other receiver, in the order of `receivers`; a UAV among the
/// receivers waits for the message of each other sender. Source: T III.2.3, spec 2.6.
struct Synchronisation {
  std::uint64_t id = 0;  ///< common to all the UAVs concerned
  std::vector<std::string> senders;
  std::vector<std::string> receivers;
  std::optional<MissionTime> deadline;  ///< once it has passed, the exit condition is satisfied
  bool operator==(const Synchronisation&) const = default;
};

/// T = (type, id, Π, Ξ, params). Source: T def. III.1.
struct Task {
  TaskId id;
  std::string type;
  Parameters parameters;
  Formula preconditions;                           ///< Π
  Formula exit;                                    ///< Ξ
  std::optional<Synchronisation> synchronisation;  ///< present exactly for types that synchronise
  bool operator==(const Task&) const = default;
};

/// Prefix of the types of joint tasks, which the supervisor carries out.
inline constexpr std::string_view kJointPrefix = "joint:";

bool is_joint(std::string_view type);

}  // namespace skein::executive
