// SPDX-License-Identifier: Apache-2.0
// A decision node without planning domain, with a functional layer that can be told what to say.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "skein/decision_node/decision_node.hpp"

namespace skein::decision_node::testing {

template <class Kind>
std::vector<Kind> all(const Effects& effects) {
  std::vector<Kind> found;
  for (const Effect& effect : effects) {
    if (const auto* one = std::get_if<Kind>(&effect)) found.push_back(*one);
  }
  return found;
}

inline executive::Start start_of(std::uint64_t id, const std::string& type) {
  executive::Start start;
  start.task.id = executive::TaskId(id);
  start.task.type = type;
  return start;
}

inline StatusTold status_of(std::uint64_t id, functional::TaskState state,
                            const std::string& reason = "") {
  return {{functional::TaskId(id), state, reason}};
}

/// What is asked of the vehicle, in words and in order: "dispatch goto", "interrupt 7".
inline std::vector<std::string> asked_of_vehicle(const Effects& effects) {
  std::vector<std::string> asked;
  for (const ToVehicle& one : all<ToVehicle>(effects)) {
    const bool stop = one.request.verb == functional::Verb::kInterrupt;
    asked.push_back(stop ? "interrupt " + std::to_string(one.request.id.value())
                         : "dispatch " + one.request.type);
  }
  return asked;
}

inline world::Telemetry flying(bool airborne) {
  world::Telemetry telemetry;
  telemetry.uav = "marvin";
  telemetry.state.airborne = airborne;
  return telemetry;
}

/// The node of "marvin" in a team with "heliv".
class FlownNode {
 public:
  explicit FlownNode(int degree, ContactPolicy policy = ContactPolicy::kContinue,
                     std::optional<temporal::Algorithm> consistency = temporal::Algorithm::kDipM)
      : FlownNode(config(degree, policy, consistency)) {}
  explicit FlownNode(Config config) : node_(std::move(config)) { born_ = give(Started{}); }

  Effects give(const Input& input) { return node_.handle(input, now_); }
  Effects restarts_at(double seconds) {
    now_ = MissionTime::seconds(seconds);
    return give(Resumed{});
  }
  Effects wake_at(double seconds) {
    now_ = MissionTime::seconds(seconds);
    return give(Tick{});
  }
  /// To the next of the ground's commands.
  Answer answer_to(mission::Request request) {
    const auto answers = all<Answer>(give(Command{{1, ++commands_}, std::move(request)}));
    return answers.empty() ? Answer() : answers.front();
  }
  MissionTime now() const { return now_; }
  std::optional<MissionTime> next_wakeup() const { return node_.next_wakeup(); }
  /// What it did when it was started.
  const Effects& born() const { return born_; }

  static Config config(int degree, ContactPolicy policy,
                       std::optional<temporal::Algorithm> consistency) {
    Config config;
    config.consistency = consistency;
    config.uav = "marvin";
    config.others = {"heliv"};
    config.degree = degree;
    config.contact_policy = policy;
    config.contact_after = Duration::seconds(30);
    return config;
  }

 private:
  DecisionNode node_;
  MissionTime now_;
  Effects born_;
  std::uint64_t commands_ = 100;
};

}  // namespace skein::decision_node::testing
