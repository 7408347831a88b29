// SPDX-License-Identifier: Apache-2.0
// Lines of the event log that every node with an executive writes: kinds task, request, sync
// (docs/journal.md).
#pragma once

#include <optional>
#include <string>

#include "skein/executive/effect.hpp"
#include "skein/executive/input.hpp"
#include "skein/journal/record.hpp"

namespace skein::translation {

/// Who writes, and when.
struct Writer {
  MissionTime at;
  std::string node;
};

journal::Record task_line(const Writer& writer, const std::string& uav,
                          const executive::TaskEvent& event);

/// `mode` counts for START only.
journal::Record request_line(const Writer& writer, const std::string& uav,
                             const executive::Reply& reply, executive::InsertionMode mode);

/// A synchronisation message that was sent or received.
struct SyncTraffic {
  std::uint64_t id = 0;
  std::string from, to;
  bool sent = false;
};
journal::Record sync_line(const Writer& writer, const SyncTraffic& message);

}  // namespace skein::translation
