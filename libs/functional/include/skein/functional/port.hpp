// SPDX-License-Identifier: Apache-2.0
// The port to one vehicle: what its functional layer is asked, and what it answers. Who speaks for
// several vehicles adds the name. What a vehicle tells besides is world/perception.hpp and
// world/telemetry.hpp. The contract: docs/functional-layer.md. Source: spec 1.1, 2.1, T II.1.
#pragma once

#include <cstdint>
#include <string>

#include "skein/functional/parameters.hpp"
#include "skein/functional/task.hpp"

namespace skein::functional {

enum class Verb : std::uint8_t { kDispatch, kInterrupt };

/// Carry this task out, or stop it. A task that comes twice is answered twice and done once.
struct Request {
  Verb verb = Verb::kDispatch;
  TaskId id;
  std::string type = {};       ///< of a dispatch: one that the registry of task types has
  Parameters parameters = {};  ///< of a dispatch
  bool operator==(const Request&) const = default;
};

/// Where a task stands: running, ended or aborted; an `aborted` that answers a dispatch is a
/// rejection; `started`: not yet, but it will come (a decision node's, of a motion that waits for
/// its air).
struct Status {
  TaskId id;
  TaskState state = TaskState::kRunning;
  std::string reason;  ///< of an abort, always
  AbortCause cause = AbortCause::kOther;
  bool operator==(const Status&) const = default;
};

}  // namespace skein::functional
