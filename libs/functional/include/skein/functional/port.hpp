// SPDX-License-Identifier: Apache-2.0
// The port to one vehicle: the requests to its functional layer, and the answers. A functional
// layer of several vehicles adds their names. Its other outputs are in world/perception.hpp and
// world/telemetry.hpp. The contract: docs/functional-layer.md. Source: spec 1.1, 2.1, T II.1.
#pragma once

#include <cstdint>
#include <string>

#include "skein/functional/parameters.hpp"
#include "skein/functional/task.hpp"

namespace skein::functional {

enum class Verb : std::uint8_t { kDispatch, kInterrupt };

/// The order to carry out a task, or to stop it. A request that is received twice is answered twice
/// and carried out once.
struct Request {
  Verb verb = Verb::kDispatch;
  TaskId id;
  std::string type = {};       ///< kDispatch only: a type of the registry of task types
  Parameters parameters = {};  ///< kDispatch only
  bool operator==(const Request&) const = default;
};

/// The status of a task: running, ended or aborted. An `aborted` that answers a dispatch is a
/// rejection. `started` comes from a decision node only: the task (a motion that waits for its air)
/// has not begun yet.
struct Status {
  TaskId id;
  TaskState state = TaskState::kRunning;
  std::string reason;  ///< given with every abort
  AbortCause cause = AbortCause::kOther;
  bool operator==(const Status&) const = default;
};

}  // namespace skein::functional
