// SPDX-License-Identifier: Apache-2.0
// Of who does which task of the team. docs/journal.md says when each is written.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "skein/journal/line.hpp"

namespace skein::journal::lines {

/// A mission for the whole team: given, refused, done.
struct GlobalMission {
  static constexpr std::string_view kKind = "global-mission";
  std::uint64_t mission = 0;
  Text state = {};
  OptionalText why = {};

  static void fields(auto& it, auto&& each) {
    each("mission", it.mission);
    each("state", it.state);
    each("why", it.why);
  }
};

/// A task of the team stands elsewhere in its book.
struct Owner {
  static constexpr std::string_view kKind = "owner";
  std::uint64_t task = 0;
  Text statement = {};
  Text stage = {};
  std::uint64_t sale = 0;
  OptionalText owners = {};
  OptionalText why = {};

  static void fields(auto& it, auto&& each) {
    each("task", it.task);
    each("statement", it.statement);
    each("stage", it.stage);
    each("sale", it.sale);
    each("owners", it.owners);
    each("why", it.why);
  }
};

/// The right to sell came here (taken) or went (lost).
struct Token {
  static constexpr std::string_view kKind = "token";
  Text uav = {};
  Text state = {};
  std::optional<std::uint64_t> term = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("state", it.state);
    each("term", it.term);
  }
};

/// Of a sale held here: sold, traded, unsold, dropped, rejected; values [s].
struct Sale {
  static constexpr std::string_view kKind = "sale";
  Text state = {};
  std::optional<std::uint64_t> task = {};
  OptionalText tasks = {};
  OptionalText uav = {};
  OptionalText to = {};
  std::optional<double> value = {};
  OptionalText next_best = {};
  std::optional<double> next_value = {};
  OptionalText why = {};

  static void fields(auto& it, auto&& each) {
    each("state", it.state);
    each("task", it.task);
    each("tasks", it.tasks);
    each("uav", it.uav);
    each("to", it.to);
    each("value", it.value);
    each("next_best", it.next_best);
    each("next_value", it.next_value);
    each("why", it.why);
  }
};

/// What a UAV offered in the first round of a sale: `added` [s]; or why it does not bid.
struct Bid {
  static constexpr std::string_view kKind = "bid";
  Text uav = {};
  std::uint64_t task = 0;
  std::uint64_t sale = 0;
  std::optional<double> added = {};
  OptionalText why = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("task", it.task);
    each("sale", it.sale);
    each("added", it.added);
    each("why", it.why);
  }
};

/// What a UAV does with a task that it was granted.
struct TeamTask {
  static constexpr std::string_view kKind = "team-task";
  Text uav = {};
  std::uint64_t task = 0;
  std::uint64_t sale = 0;
  Text state = {};
  std::uint64_t goal = 0;
  Text statement = {};
  OptionalText why = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("task", it.task);
    each("sale", it.sale);
    each("state", it.state);
    each("goal", it.goal);
    each("statement", it.statement);
    each("why", it.why);
  }
};

}  // namespace skein::journal::lines
