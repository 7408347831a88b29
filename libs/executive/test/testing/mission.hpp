// SPDX-License-Identifier: Apache-2.0
// An executive under test with its clock, and short ways to write tasks, conditions and inputs.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "skein/executive/executive.hpp"
#include "testing/show.hpp"

namespace skein::executive::testing {

// --- conditions ---

inline Literal ce(std::uint64_t id, TaskState state) {
  return Literal{TaskInState{TaskId{id}, state}};
}
inline Literal cm(std::string message) { return Literal{MessageReceived{std::move(message)}}; }
inline Literal passed(double instant) {
  return Literal{TimeIs{MissionTime::seconds(instant), true}};
}
inline Literal not_yet(double instant) {
  return Literal{TimeIs{MissionTime::seconds(instant), false}};
}
inline Literal no(Literal literal) {
  literal.negated = !literal.negated;
  return literal;
}
inline Literal optional(Literal literal) {
  literal.modality = Modality::kOptional;
  return literal;
}

// --- tasks ---

/// A task of this type; clauses are added one by one.
class TaskOf {
 public:
  TaskOf(std::uint64_t id, std::string type) {
    task_.id = TaskId{id};
    task_.type = std::move(type);
  }
  TaskOf& pre(Clause clause) {
    task_.preconditions.push_back(std::move(clause));
    return *this;
  }
  TaskOf& exit(Clause clause) {
    task_.exit.push_back(std::move(clause));
    return *this;
  }
  TaskOf& device(std::string name) {
    task_.parameters.add(Parameter{"device", std::move(name), {}});
    return *this;
  }
  TaskOf& among(std::vector<std::string> senders, std::vector<std::string> receivers) {
    task_.synchronisation = Synchronisation{551, std::move(senders), std::move(receivers), {}};
    return *this;
  }
  TaskOf& deadline(double instant) {
    task_.synchronisation->deadline = MissionTime::seconds(instant);
    return *this;
  }
  operator Task() const { return task_; }  // NOLINT(google-explicit-constructor): reads as a task

 private:
  Task task_;
};

// --- inputs ---

using Words = std::vector<std::string>;

inline Config named(std::string name) {
  Config config;
  config.name = std::move(name);
  return config;
}

/// Each call is one input; it returns what happened, as words, without the replies of accepted
/// requests. `notices` and `effects` are those of the last input.
class Mission {
 public:
  explicit Mission(Config config = named("marvin")) : executive(std::move(config)) {}

  Mission& at(double instant) {
    now = MissionTime::seconds(instant);
    return *this;
  }
  Words give(const Input& input) { return show(executive.handle(input, now)); }
  Words give_up(std::uint64_t id, const std::string& why) {
    return show(executive.give_up(TaskId{id}, why, now));
  }
  Words start(const Task& task, InsertionMode mode = InsertionMode::kSeq) {
    return give(Start{task, mode});
  }
  Words abort(std::uint64_t id) { return give(Abort{TaskId{id}}); }
  Words message(const std::string& text) { return give(ProcessMessage{text}); }
  Words suppress(std::uint64_t id) { return give(Suppress{TaskId{id}}); }
  Words status(std::uint64_t id, TaskState state, const std::string& reason = {}) {
    return give(FunctionalStatus{TaskId{id}, state, reason});
  }
  Words runs(std::uint64_t id) { return status(id, TaskState::kRunning); }
  Words ends(std::uint64_t id) { return status(id, TaskState::kEnded); }
  Words aborted(std::uint64_t id) { return status(id, TaskState::kAborted); }
  Words update(std::uint64_t id, std::optional<Formula> pre, std::optional<Formula> exit) {
    return give(UpdateConditions{TaskId{id}, std::move(pre), std::move(exit)});
  }
  Words sync_from(const std::string& uav, std::uint64_t id = 551) {
    return give(SyncReceived{id, uav});
  }
  Words reachable(const std::string& uav) { return give(PeerReachable{uav}); }
  Words flies(bool airborne = true) { return give(Flight{airborne}); }
  Words tick() { return give(Tick{}); }
  Words hears_again() { return give(Tick{true}); }

  TaskState state_of(std::uint64_t id) const { return executive.find(TaskId{id})->state; }
  std::string reason_of(std::uint64_t id) const { return executive.find(TaskId{id})->reason; }
  /// The refusal in the last effects, or nothing.
  std::string why() const {
    for (const Effect& effect : effects) {
      if (const auto* reply = std::get_if<Reply>(&effect)) return reply->why;
    }
    return {};
  }

  Executive executive;
  MissionTime now;
  Effects effects;
  std::vector<std::string> notices;

 private:
  Words show(Effects happened) {
    effects = std::move(happened);
    notices.clear();
    for (const Effect& effect : effects) {
      if (const auto* notice = std::get_if<Notice>(&effect)) notices.push_back(notice->text);
    }
    return show_happenings(effects);
  }
};

}  // namespace skein::executive::testing
