// SPDX-License-Identifier: Apache-2.0
// Of plans and what they are made for, by decision nodes. docs/journal.md says when each is
// written.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "skein/journal/line.hpp"

namespace skein::journal::lines {

/// A high-level task entered a state.
struct Goal {
  static constexpr std::string_view kKind = "goal";
  Text uav = {};
  std::uint64_t goal = 0;
  std::uint64_t mission = 0;
  Text statement = {};
  Text state = {};
  OptionalText why = {};
  Text asked_by = {};
  OptionalText done = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("goal", it.goal);
    each("mission", it.mission);
    each("statement", it.statement);
    each("state", it.state);
    each("why", it.why);
    each("asked_by", it.asked_by);
    each("done", it.done);
  }
};

/// The plan has a new revision.
struct Plan {
  static constexpr std::string_view kKind = "plan";
  Text uav = {};
  std::uint64_t revision = 0;
  std::uint64_t tasks = 0;
  std::uint64_t goals = 0;
  std::optional<double> earliest_end = {};
  std::optional<double> latest_end = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("revision", it.revision);
    each("tasks", it.tasks);
    each("goals", it.goals);
    each("earliest_end", it.earliest_end);
    each("latest_end", it.latest_end);
  }
};

/// A task that is new or changed in a revision; dates [s], unbounded ones left out.
struct Planned {
  static constexpr std::string_view kKind = "planned";
  Text uav = {};
  std::uint64_t revision = 0;
  std::uint64_t task = 0;
  Text type = {};
  std::uint64_t goal = 0;
  double earliest_start = 0;
  OptionalText device = {};
  OptionalNumbers target = {};
  std::optional<double> latest_start = {};
  double earliest_end = 0;
  std::optional<double> latest_end = {};
  Text after = {};
  OptionalText stop = {};
  Text methods = {};
  bool committed = false;
  OptionalNumbers way = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("revision", it.revision);
    each("task", it.task);
    each("type", it.type);
    each("goal", it.goal);
    each("earliest_start", it.earliest_start);
    each("device", it.device);
    each("target", it.target);
    each("latest_start", it.latest_start);
    each("earliest_end", it.earliest_end);
    each("latest_end", it.latest_end);
    each("after", it.after);
    each("stop", it.stop);
    each("methods", it.methods);
    each("committed", it.committed);
    each("way", it.way);
  }
};

/// An operator of the supervisor was applied; `took` [s of the mission].
struct Decision {
  static constexpr std::string_view kKind = "decision";
  Text uav = {};
  std::uint64_t number = 0;
  Text operator_ = {};
  Text cause = {};
  Text inputs = {};
  Text outcome = {};
  double took = 0;

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("number", it.number);
    each("operator", it.operator_);
    each("cause", it.cause);
    each("inputs", it.inputs);
    each("outcome", it.outcome);
    each("took", it.took);
  }
};

/// What became of a unit mission that was accepted for planning.
struct Answer {
  static constexpr std::string_view kKind = "answer";
  Text uav = {};
  std::uint64_t mission = 0;
  bool planned = false;
  OptionalText why = {};
  std::optional<bool> evaluated = {};
  OptionalText placement = {};
  std::optional<double> cost = {};
  std::optional<double> energy = {};
  std::optional<double> earliest_end = {};
  std::optional<double> latest_end = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("mission", it.mission);
    each("planned", it.planned);
    each("why", it.why);
    each("evaluated", it.evaluated);
    each("placement", it.placement);
    each("cost", it.cost);
    each("energy", it.energy);
    each("earliest_end", it.earliest_end);
    each("latest_end", it.latest_end);
  }
};

/// A motion that needs air: what it got (`air`), or what it wants while others are to leave it
/// (`wants`); x, y, x, y, radius, floor, ceiling [m] of each volume.
struct Air {
  static constexpr std::string_view kKind = "air";
  Text uav = {};
  std::uint64_t task = 0;
  Text type = {};
  Text state = {};
  double waited = 0;
  OptionalText for_ = {};
  std::optional<double> raised = {};
  OptionalNumbers air = {};
  OptionalNumbers wants = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("task", it.task);
    each("type", it.type);
    each("state", it.state);
    each("waited", it.waited);
    each("for", it.for_);
    each("raised", it.raised);
    each("air", it.air);
    each("wants", it.wants);
  }
};

/// What a UAV knows of those whom it is to meet; dates [s].
struct Meeting {
  static constexpr std::string_view kKind = "meeting";
  Text uav = {};
  std::uint64_t id = 0;
  bool known = false;
  std::optional<bool> order = {};
  OptionalText last = {};
  std::optional<bool> there = {};
  std::optional<double> soonest = {};
  std::optional<double> slowest = {};
  std::optional<std::uint64_t> behind = {};
  std::optional<double> needed = {};
  OptionalText needed_by = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("id", it.id);
    each("known", it.known);
    each("order", it.order);
    each("last", it.last);
    each("there", it.there);
    each("soonest", it.soonest);
    each("slowest", it.slowest);
    each("behind", it.behind);
    each("needed", it.needed);
    each("needed_by", it.needed_by);
  }
};

/// What lies between meetings, sent or received.
struct Frontier {
  static constexpr std::string_view kKind = "frontier";
  Text uav = {};
  Text direction = {};
  OptionalText to = {};
  OptionalText from = {};
  OptionalText about = {};
  std::optional<std::uint64_t> meetings = {};
  std::optional<std::uint64_t> arcs = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("direction", it.direction);
    each("to", it.to);
    each("from", it.from);
    each("about", it.about);
    each("meetings", it.meetings);
    each("arcs", it.arcs);
  }
};

}  // namespace skein::journal::lines
