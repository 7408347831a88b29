// SPDX-License-Identifier: Apache-2.0
// Of the mission and its operators, by the ground station and UAVs. docs/journal.md says when each
// is written.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "skein/journal/line.hpp"

namespace skein::journal::lines {

/// A mission began or ended: started; finished (by the ground's script); time-limit; resumed.
struct Mission {
  static constexpr std::string_view kKind = "mission";
  Text state = {};

  static void fields(auto& it, auto&& each) { each("state", it.state); }
};

/// A phase of the mission was entered.
struct Phase {
  static constexpr std::string_view kKind = "phase";
  Text name = {};

  static void fields(auto& it, auto&& each) { each("name", it.name); }
};

/// A step of the ground's script was carried out.
struct Step {
  static constexpr std::string_view kKind = "step";
  Text name = {};

  static void fields(auto& it, auto&& each) { each("name", it.name); }
};

/// A scripted operator acted.
struct Operator {
  static constexpr std::string_view kKind = "operator";
  Text does = {};

  static void fields(auto& it, auto&& each) { each("does", it.does); }
};

/// An operator asked for something while the mission ran.
struct Asked {
  static constexpr std::string_view kKind = "asked";
  Text who = {};
  std::uint64_t number = 0;
  Text what = {};
  bool accepted = false;
  OptionalText why = {};

  static void fields(auto& it, auto&& each) {
    each("who", it.who);
    each("number", it.number);
    each("what", it.what);
    each("accepted", it.accepted);
    each("why", it.why);
  }
};

/// Who has a UAV in hand from now on, and who asks for it; left out: nobody.
struct Hand {
  static constexpr std::string_view kKind = "hand";
  Text uav = {};
  OptionalText holder = {};
  OptionalText asker = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("holder", it.holder);
    each("asker", it.asker);
  }
};

/// A command to a UAV, by number: issued, delivered, then acknowledged, refused or expired.
struct Command {
  static constexpr std::string_view kKind = "command";
  Text uav = {};
  std::uint64_t command = 0;
  Text what = {};
  Text state = {};
  OptionalText why = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("command", it.command);
    each("what", it.what);
    each("state", it.state);
    each("why", it.why);
  }
};

/// The autonomy degree of a UAV, with how many tasks handed over.
struct Degree {
  static constexpr std::string_view kKind = "degree";
  Text uav = {};
  std::int64_t degree = 0;
  OptionalText by = {};
  std::optional<std::int64_t> held = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("degree", it.degree);
    each("by", it.by);
    each("held", it.held);
  }
};

/// A plan that a UAV handed over: held, resumed, dropped.
struct Held {
  static constexpr std::string_view kKind = "held";
  Text uav = {};
  std::uint64_t tasks = 0;
  Text state = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("tasks", it.tasks);
    each("state", it.state);
  }
};

/// The operator says that it will never be heard again.
struct LostUav {
  static constexpr std::string_view kKind = "lost-uav";
  Text uav = {};

  static void fields(auto& it, auto&& each) { each("uav", it.uav); }
};

/// The operator takes back that it is lost.
struct FoundUav {
  static constexpr std::string_view kKind = "found-uav";
  Text uav = {};

  static void fields(auto& it, auto&& each) { each("uav", it.uav); }
};

/// The contact-loss policy is carried out: hold or return.
struct Contact {
  static constexpr std::string_view kKind = "contact";
  Text uav = {};
  Text policy = {};
  OptionalText why = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("policy", it.policy);
    each("why", it.why);
  }
};

/// Something worth a sentence that has no kind of its own.
struct Notice {
  static constexpr std::string_view kKind = "notice";
  OptionalText uav = {};
  Text text = {};

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("text", it.text);
  }
};

/// An alarm was raised, confirmed or infirmed; belief in [0, 1].
struct Alarm {
  static constexpr std::string_view kKind = "alarm";
  std::uint64_t alarm = 0;
  Text state = {};
  std::vector<double> position = {};
  double belief = 0;

  static void fields(auto& it, auto&& each) {
    each("alarm", it.alarm);
    each("state", it.state);
    each("position", it.position);
    each("belief", it.belief);
  }
};

/// A look of a sensor with at least one detection reached the ground.
struct Perception {
  static constexpr std::string_view kKind = "perception";
  Text uav = {};
  Text device = {};
  std::uint64_t detections = 0;

  static void fields(auto& it, auto&& each) {
    each("uav", it.uav);
    each("device", it.device);
    each("detections", it.detections);
  }
};

/// An object that is followed: where sensors saw it last [s], with what standard deviation [m].
struct Seen {
  static constexpr std::string_view kKind = "seen";
  Text name = {};
  Text type = {};
  std::vector<double> position = {};
  double spread = 0;
  double when = 0;

  static void fields(auto& it, auto&& each) {
    each("name", it.name);
    each("type", it.type);
    each("position", it.position);
    each("spread", it.spread);
    each("when", it.when);
  }
};

}  // namespace skein::journal::lines
