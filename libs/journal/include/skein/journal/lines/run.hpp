// SPDX-License-Identifier: Apache-2.0
// Of a run, by who runs it. docs/journal.md says when each is written.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "skein/journal/line.hpp"

namespace skein::journal::lines {

/// A daemon: started, ready, exited, crashed; processor time [s], greatest resident memory [MB].
struct Process {
  static constexpr std::string_view kKind = "process";
  Text name = {};
  Text state = {};
  OptionalText why = {};
  std::optional<double> cpu = {};
  std::optional<double> memory = {};

  static void fields(auto& it, auto&& each) {
    each("name", it.name);
    each("state", it.state);
    each("why", it.why);
    each("cpu", it.cpu);
    each("memory", it.memory);
  }
};

/// What the script of a mission that was not finished still waited for.
struct Waiting {
  static constexpr std::string_view kKind = "waiting";
  Text step = {};
  Text awaited = {};
  Text is = {};
  std::optional<double> since = {};
  OptionalText why = {};

  static void fields(auto& it, auto&& each) {
    each("step", it.step);
    each("for", it.awaited);
    each("is", it.is);
    each("since", it.since);
    each("why", it.why);
  }
};

/// A verdict: the last lines of the log.
struct Expectation {
  static constexpr std::string_view kKind = "expectation";
  Text name = {};
  bool passed = false;
  Text seen = {};

  static void fields(auto& it, auto&& each) {
    each("name", it.name);
    each("passed", it.passed);
    each("seen", it.seen);
  }
};

}  // namespace skein::journal::lines
