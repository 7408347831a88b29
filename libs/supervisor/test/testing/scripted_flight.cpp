// SPDX-License-Identifier: Apache-2.0
#include "scripted_flight.hpp"

#include <variant>

namespace skein::supervisor {

using executive::FunctionalStatus;
using executive::TaskState;

Durations draw_durations(const Tasks& tasks, Random& random) {
  Durations durations;
  for (const auto& task : tasks) {
    if (!task.stop.empty() || task.open_ended) continue;
    std::int64_t least = task.duration.least.count();
    const std::int64_t most = task.duration.most.count();
    if (least == 0 && most > 0) least = 1'000'000;  // nature takes a millisecond at least
    const auto width = static_cast<std::uint64_t>(most - least);
    const std::int64_t between = least + static_cast<std::int64_t>(random.below(width + 1));
    const std::uint64_t which = random.below(3);
    durations[task.id] = Duration::nanoseconds(which == 0 ? least : which == 1 ? most : between);
  }
  return durations;
}

namespace {

executive::Config config() {
  executive::Config config;
  config.name = "karma";
  return config;
}

}  // namespace

ScriptedFlight::ScriptedFlight(const Tasks& tasks, Durations durations)
    : executive_(config()), durations_(std::move(durations)) {
  for (const auto& task : tasks) tasks_[task.id] = task;
}

void ScriptedFlight::begin(const std::vector<executive::Input>& requests) {
  for (const executive::Input& one : requests) take(one, MissionTime());
}

void ScriptedFlight::run_until(MissionTime end) {
  while (step(end)) {
  }
}

std::optional<MissionTime> ScriptedFlight::step(MissionTime end) {
  const auto status = to_come_.empty() ? std::nullopt : std::optional(to_come_.begin()->first);
  const auto next = earliest(status, executive_.next_wakeup());
  if (!next || *next > end) return std::nullopt;
  if (status && *status == *next) {
    const executive::Input input = to_come_.begin()->second;
    to_come_.erase(to_come_.begin());
    take(input, *next);
  } else {
    take(executive::Tick{}, *next);
  }
  return next;
}

TaskState ScriptedFlight::state(std::uint64_t task) const {
  const auto view = executive_.find(id(task));
  return view ? view->state : TaskState::kScheduled;
}

void ScriptedFlight::take(const executive::Input& input, MissionTime now) {
  for (const executive::Effect& effect : executive_.handle(input, now)) on(effect, now);
}

void ScriptedFlight::later(executive::TaskId task, executive::Input input, MissionTime now) {
  const auto duration = durations_.find(task);
  if (duration != durations_.end()) to_come_.emplace(now + duration->second, std::move(input));
}

void ScriptedFlight::on(const executive::Effect& effect, MissionTime now) {
  if (const auto* event = std::get_if<executive::TaskEvent>(&effect)) {
    on(*event, now);
  } else if (const auto* dispatch = std::get_if<executive::Dispatch>(&effect)) {
    told_.push_back("dispatch " + to_text(dispatch->id));
    to_come_.emplace(now, FunctionalStatus{dispatch->id, TaskState::kRunning, {}});
    later(dispatch->id, FunctionalStatus{dispatch->id, TaskState::kEnded, {}}, now);
  } else if (const auto* stop = std::get_if<executive::Interrupt>(&effect)) {
    told_.push_back("interrupt " + to_text(stop->id));
    to_come_.emplace(now, FunctionalStatus{stop->id, TaskState::kAborted, {}});
  } else if (const auto* reply = std::get_if<executive::Reply>(&effect)) {
    if (!reply->accepted) told_.push_back("refused: " + reply->why);
  }
}

void ScriptedFlight::on(const executive::TaskEvent& event, MissionTime now) {
  Observation& seen = seen_[event.id];
  if (event.state == TaskState::kStarted) seen.started = now;
  if (executive::is_terminal(event.state)) {
    seen.over = now;
    seen.aborted = event.state == TaskState::kAborted;
  }
  const auto& task = tasks_.at(event.id);
  if (event.state == TaskState::kRunning && task.synchronisation) {
    later(event.id, executive::SyncReceived{task.synchronisation->id, "heliv"}, now);
  }
}

}  // namespace skein::supervisor
