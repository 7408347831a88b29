// SPDX-License-Identifier: Apache-2.0
// Of elementary tasks, by executives and functional layers. docs/journal.md says when each is
// written.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "skein/journal/line.hpp"

namespace skein::journal::lines {

/// An executive answered a request; `mode` of a START.
struct Request {
  static constexpr std::string_view kKind = "request";
  Text uav = {};
  Text request = {};
  OptionalText mode = {};
  std::optional<std::uint64_t> task = {};
  bool accepted = false;
  OptionalText why = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("request", it.request);
    each("mode", it.mode);
    each("task", it.task);
    each("accepted", it.accepted);
    each("why", it.why);
  }
};

/// A task entered a state.
struct Task {
  static constexpr std::string_view kKind = "task";
  Text uav = {};
  std::uint64_t task = 0;
  Text type = {};
  Text state = {};
  OptionalText device = {};
  OptionalNumbers target = {};
  OptionalText reason = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("task", it.task);
    each("type", it.type);
    each("state", it.state);
    each("device", it.device);
    each("target", it.target);
    each("reason", it.reason);
  }
};

/// A synchronisation message left (sent) or was heard (received) by an executive.
struct Sync {
  static constexpr std::string_view kKind = "sync";
  std::uint64_t id = 0;
  Text from = {};
  Text to = {};
  Text direction = {};
  OptionalText word = {};

  static void fields(auto& it, auto&& each) {
    each("id", it.id);
    each("from", it.from);
    each("to", it.to);
    each("direction", it.direction);
    each("word", it.word);
  }
};

/// Truth: the functional layer of a vehicle began or finished a task.
struct Functional {
  static constexpr std::string_view kKind = "functional";
  Text uav = {};
  std::uint64_t task = 0;
  Text type = {};
  Text state = {};
  OptionalText device = {};
  OptionalNumbers target = {};
  OptionalText reason = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("task", it.task);
    each("type", it.type);
    each("state", it.state);
    each("device", it.device);
    each("target", it.target);
    each("reason", it.reason);
  }
};

}  // namespace skein::journal::lines
