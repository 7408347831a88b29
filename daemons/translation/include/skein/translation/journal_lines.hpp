// SPDX-License-Identifier: Apache-2.0
// Lines of the event log that every node with an executive writes: kinds task, request, sync
// (docs/journal.md).
#pragma once

#include <optional>
#include <string>

#include "skein/executive/effect.hpp"
#include "skein/executive/input.hpp"
#include "skein/executive/task.hpp"
#include "skein/journal/record.hpp"

namespace skein::translation {

/// Who writes, and when.
struct Writer {
  MissionTime at;
  std::string node;
};

/// With the device and the target [m] ENU among the task's parameters, if it has them.
journal::Record task_line(const Writer& writer, const std::string& uav,
                          const executive::TaskEvent& event,
                          const executive::Parameters& parameters);

/// Adds `device` and `target` (x y z) to a line, each if the parameters have it.
void with_device_and_target(journal::Record& line, const executive::Parameters& parameters);

/// `mode` counts for START only.
journal::Record request_line(const Writer& writer, const std::string& uav,
                             const executive::Reply& reply, executive::InsertionMode mode);

/// A synchronisation message that was sent or received.
struct SyncTraffic {
  std::uint64_t id = 0;
  std::string from, to;
  bool sent = false;
  executive::SyncWord word = executive::SyncWord::kThere;
};
journal::Record sync_line(const Writer& writer, const SyncTraffic& message);

}  // namespace skein::translation
