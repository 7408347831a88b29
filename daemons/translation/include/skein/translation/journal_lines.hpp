// SPDX-License-Identifier: Apache-2.0
// Lines of the event log that every node with an executive writes: kinds task, request, sync
// (docs/journal.md).
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "skein/executive/effect.hpp"
#include "skein/executive/input.hpp"
#include "skein/executive/task.hpp"
#include "skein/journal/line.hpp"

namespace skein::translation {

/// The writing node and the time of a record.
struct Writer {
  MissionTime at;
  std::string node;

  template <class Line>
  journal::Record record(Line line) const {
    return journal::record_of(at, node, std::move(line));
  }
};

/// With the device and the target [m] ENU among the task's parameters, if it has them.
journal::Record task_line(const Writer& writer, const std::string& uav,
                          const executive::TaskEvent& event,
                          const executive::Parameters& parameters);

/// Device and target [m] ENU of a task, as far as its parameters have them.
journal::OptionalText device_of(const executive::Parameters& parameters);
journal::OptionalNumbers target_of(const executive::Parameters& parameters);

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
