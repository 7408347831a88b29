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

/// The executive reads none of them but the device that names a resource (spec 2.5); they travel
/// through it to whoever carries the task out.
using functional::Parameter;
using functional::Parameters;

/// What a task of a type that synchronises does (`synchronise`, `rendezvous`). A UAV among the
/// senders sends one message to each other receiver, in the order of `receivers`; a UAV among the
/// receivers waits for the message of each other sender. Source: T III.2.3, spec 2.6.
struct Synchronisation {
  std::uint64_t id = 0;  ///< common to all the UAVs concerned
  std::vector<std::string> senders;
  std::vector<std::string> receivers;
  std::optional<MissionTime> deadline;  ///< once passed, it counts as a satisfied exit condition
  bool operator==(const Synchronisation&) const = default;
};

/// T = (type, id, Π, Ξ, params). Source: T def. III.1.
struct Task {
  TaskId id;
  std::string type;
  Parameters parameters;
  Formula preconditions;                           ///< Π
  Formula exit;                                    ///< Ξ
  std::optional<Synchronisation> synchronisation;  ///< present exactly for those types
  bool operator==(const Task&) const = default;
};

/// Joint tasks are the types that begin with this; the supervisor carries them out.
inline constexpr std::string_view kJointPrefix = "joint:";

bool is_joint(std::string_view type);

}  // namespace skein::executive
