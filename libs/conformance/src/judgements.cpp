// SPDX-License-Identifier: Apache-2.0
// What keeps a point. Nothing is said as long as it may still be kept.
#include <algorithm>
#include <cmath>

#include "skein/conformance/conformance.hpp"

namespace skein::conformance {

using functional::Status;
using functional::TaskState;

namespace {

/// Samples of telemetry that are looked at.
constexpr std::size_t kSamples = 3;
/// Slower than this it stays where it is [m/s].
constexpr double kStill = 0.5;
/// How far a vehicle that cannot hover may go astray from where it is told to stay [m].
constexpr double kCircle = 200;

bool has(const std::vector<Status>& statuses, TaskState state) {
  return std::any_of(statuses.begin(), statuses.end(),
                     [&](const Status& one) { return one.state == state; });
}

std::string problem_of(const world::Telemetry& telemetry) {
  const world::VehicleState& state = telemetry.state;
  if (!state.position.allFinite() || !state.velocity.allFinite()) return "a place that is none";
  if (!(state.energy >= 0 && state.energy <= 1)) return "an energy that is not within 0 and 1";
  if (!std::isfinite(state.heading)) return "a heading that is none";
  return "";
}

}  // namespace

std::vector<Status> Conformance::of_task() const {
  const functional::TaskId task = refused_.value_or(asked_.id);
  std::vector<Status> found;
  for (const Status& one : seen_.statuses) {
    if (one.id == task) found.push_back(one);
  }
  return found;
}

Conformance::Judgement Conformance::tells_of_itself(MissionTime) const {
  const auto& told = seen_.telemetry;
  if (told.size() < kSamples) return std::nullopt;
  for (const world::Telemetry& one : told) {
    if (const std::string problem = problem_of(one); !problem.empty()) return problem;
  }
  for (std::size_t i = 1; i < told.size(); ++i) {
    const Duration between = told[i].at - told[i - 1].at;
    if (between > config_.telemetry_within) {
      return std::to_string(between.to_seconds()) + " s without telemetry";
    }
  }
  return "";
}

Conformance::Judgement Conformance::refused(MissionTime) const {
  const std::vector<Status> told = of_task();
  if (told.empty()) return std::nullopt;
  if (told.front().state != TaskState::kAborted) return std::string(to_text(told.front().state));
  return told.front().reason.empty() ? "aborted without a reason" : "";
}

Conformance::Judgement Conformance::aborted(MissionTime) const {
  const std::vector<Status> told = of_task();
  if (has(told, TaskState::kEnded)) return "ended";
  if (!has(told, TaskState::kAborted)) return std::nullopt;
  return told.back().reason.empty() ? "aborted without a reason" : "";
}

Conformance::Judgement Conformance::runs(MissionTime) const {
  const std::vector<Status> told = of_task();
  if (told.empty()) return std::nullopt;
  if (told.front().state == TaskState::kRunning) return "";
  return std::string(to_text(told.front().state)) + ": " + told.front().reason;
}

Conformance::Judgement Conformance::is_up(MissionTime) const {
  const std::vector<Status> told = of_task();
  if (has(told, TaskState::kAborted)) return "aborted: " + told.back().reason;
  if (!has(told, TaskState::kEnded)) return std::nullopt;
  if (!has(told, TaskState::kRunning)) return "ended without having run";
  if (seen_.telemetry.empty() || seen_.telemetry.back().at < seen_.began) return std::nullopt;
  return is_airborne() ? Judgement("") : std::nullopt;
}

Conformance::Judgement Conformance::told_again(MissionTime) const {
  const std::vector<Status> told = of_task();
  if (told.empty()) return std::nullopt;
  if (told.front().state == TaskState::kAborted) return "aborted: " + told.front().reason;
  return "";
}

Conformance::Judgement Conformance::arrives(MissionTime) const {
  const std::vector<Status> told = of_task();
  if (has(told, TaskState::kAborted)) return "aborted: " + told.back().reason;
  if (!has(told, TaskState::kEnded)) return std::nullopt;
  if (!has(told, TaskState::kRunning)) return "ended without having run";
  const std::vector<double>& way = asked_.parameters.find("waypoints")->numbers;
  const world::Vector3 end(way[3], way[4], way[5]);
  double nearest = 1e9;
  for (const world::Telemetry& one : seen_.telemetry) {
    nearest = std::min(nearest, (one.state.position - end).norm());
  }
  // Telemetry is a second apart: the last one may lie before the end.
  const double between = seen_.telemetry.empty() ? 0 : seen_.telemetry.back().state.velocity.norm();
  if (nearest <= config_.near + between * config_.telemetry_within.to_seconds()) return "";
  return "ended " + std::to_string(nearest) + " m from its last way-point";
}

Conformance::Judgement Conformance::stays(MissionTime now) const {
  const Judgement is_aborted = aborted(now);
  if (!is_aborted || !is_aborted->empty()) return is_aborted;
  if (!config_.hovers) {
    const auto& told = seen_.telemetry;
    if (told.size() < kSamples * 10) return std::nullopt;
    const double away = (told.back().state.position - told.front().state.position).norm();
    return away < kCircle ? "" : "it goes on: " + std::to_string(away) + " m away";
  }
  const auto& told = seen_.telemetry;
  if (told.size() < kSamples) return std::nullopt;
  const bool still = std::all_of(told.end() - kSamples, told.end(), [](const auto& one) {
    return one.state.velocity.norm() < kStill;
  });
  return still ? Judgement("") : std::nullopt;
}

Conformance::Judgement Conformance::looks(MissionTime) const {
  const std::vector<Status> told = of_task();
  if (has(told, TaskState::kAborted)) return "aborted: " + told.back().reason;
  if (!has(told, TaskState::kRunning)) return std::nullopt;
  const bool seen = std::any_of(seen_.perceptions.begin(), seen_.perceptions.end(),
                                [&](const world::Perception& one) {
                                  return one.device == config_.device && one.range > 0 &&
                                         std::abs(one.direction.norm() - 1) < 1e-6;
                                });
  return seen ? Judgement("") : std::nullopt;
}

Conformance::Judgement Conformance::is_back(MissionTime) const {
  return seen_.restarted ? Judgement("") : std::nullopt;
}

Conformance::Judgement Conformance::is_down(MissionTime) const {
  const std::vector<Status> told = of_task();
  if (has(told, TaskState::kAborted)) return "aborted: " + told.back().reason;
  if (!has(told, TaskState::kEnded) || is_airborne()) return std::nullopt;
  return "";
}

}  // namespace skein::conformance
