// SPDX-License-Identifier: Apache-2.0
// Of joint tasks, by their members. docs/journal.md says when each is written.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "skein/journal/line.hpp"

namespace skein::journal::lines {

/// Where a UAV stands in a joint task; `start` [s].
struct Joint {
  static constexpr std::string_view kKind = "joint";
  Text uav = {};
  Text joint = {};
  std::uint64_t task = 0;
  Text model = {};
  Text variant = {};
  Text phase = {};
  OptionalText role = {};
  OptionalText holders = {};
  OptionalText blocks = {};
  OptionalText violated = {};
  std::optional<double> start = {};
  OptionalText why = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("joint", it.joint);
    each("task", it.task);
    each("model", it.model);
    each("variant", it.variant);
    each("phase", it.phase);
    each("role", it.role);
    each("holders", it.holders);
    each("blocks", it.blocks);
    each("violated", it.violated);
    each("start", it.start);
    each("why", it.why);
  }
};

/// A block, task or coordination action of a role entered a state.
struct Role {
  static constexpr std::string_view kKind = "role";
  Text uav = {};
  Text joint = {};
  Text role = {};
  Text componel = {};
  Text state = {};
  Text block = {};
  OptionalText because = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("joint", it.joint);
    each("role", it.role);
    each("componel", it.componel);
    each("state", it.state);
    each("block", it.block);
    each("because", it.because);
  }
};

/// A role asked for a task of the executive's, for the joint task `of`.
struct RoleTask {
  static constexpr std::string_view kKind = "role-task";
  Text uav = {};
  Text joint = {};
  Text role = {};
  Text componel = {};
  Text block = {};
  std::uint64_t task = 0;
  std::uint64_t of = 0;
  Text type = {};
  OptionalText because = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("joint", it.joint);
    each("role", it.role);
    each("componel", it.componel);
    each("block", it.block);
    each("task", it.task);
    each("of", it.of);
    each("type", it.type);
    each("because", it.because);
  }
};

/// A local parameter of a role was computed, or could not be, and why.
struct Place {
  static constexpr std::string_view kKind = "place";
  Text uav = {};
  Text joint = {};
  Text role = {};
  Text parameter = {};
  Text by = {};
  OptionalNumbers position = {};
  OptionalText scms = {};
  OptionalText why = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("joint", it.joint);
    each("role", it.role);
    each("parameter", it.parameter);
    each("by", it.by);
    each("position", it.position);
    each("scms", it.scms);
    each("why", it.why);
  }
};

/// A spatial constraint model became violated, satisfied or undetermined.
struct Scm {
  static constexpr std::string_view kKind = "scm";
  Text uav = {};
  Text joint = {};
  Text role = {};
  Text scm = {};
  Text state = {};
  OptionalText place = {};
  OptionalText relation = {};
  std::optional<double> measured = {};
  std::optional<double> required = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("joint", it.joint);
    each("role", it.role);
    each("scm", it.scm);
    each("state", it.state);
    each("place", it.place);
    each("relation", it.relation);
    each("measured", it.measured);
    each("required", it.required);
  }
};

/// A session, named by its subject, its opener and when it was opened [s].
struct Negotiation {
  static constexpr std::string_view kKind = "negotiation";
  Text uav = {};
  Text joint = {};
  Text modality = {};
  Text opener = {};
  double opened = 0;
  Text state = {};
  OptionalText rows = {};
  OptionalText why = {};
  OptionalText unconfirmed = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("joint", it.joint);
    each("modality", it.modality);
    each("opener", it.opener);
    each("opened", it.opened);
    each("state", it.state);
    each("rows", it.rows);
    each("why", it.why);
    each("unconfirmed", it.unconfirmed);
  }
};

}  // namespace skein::journal::lines
