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
      : node_(config(degree, policy, consistency)) {
    give(Started{});
  }

  Effects give(const Input& input) { return node_.handle(input, now_); }
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

 private:
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

  DecisionNode node_;
  MissionTime now_;
  std::uint64_t commands_ = 100;
};

}  // namespace skein::decision_node::testing
