// SPDX-License-Identifier: Apache-2.0
// Random traces: few ids, messages and instants, so that everything meets everything.
#pragma once

#include <utility>
#include <vector>

#include "skein/executive/input.hpp"
#include "skein/foundation/random.hpp"

namespace skein::executive::testing {

class RandomTrace {
 public:
  explicit RandomTrace(std::uint64_t seed) : random_(seed) {}

  /// Inputs with non-decreasing instants of whole seconds.
  std::vector<std::pair<MissionTime, Input>> make(std::size_t length) {
    std::vector<std::pair<MissionTime, Input>> trace;
    double at = 0;
    for (std::size_t i = 0; i < length; ++i) {
      if (random_.chance(0.4)) at += static_cast<double>(random_.below(4));
      trace.emplace_back(MissionTime::seconds(at), input(at));
    }
    return trace;
  }

 private:
  template <class T>
  T one_of(const std::vector<T>& all) {
    return all[random_.below(all.size())];
  }
  // One of the last tasks; now and then one to come.
  TaskId id() {
    const std::uint64_t first = next_ > 8 ? next_ - 8 : 0;
    return random_.chance(0.03) ? TaskId{next_ + 1} : TaskId{1 + first + random_.below(8)};
  }
  // What a condition of the task being made names: mostly one before it.
  TaskId id_before() {
    const std::uint64_t first = next_ > 8 ? next_ - 8 : 0;
    return random_.chance(0.03) || next_ < 2 ? id()
                                             : TaskId{1 + first + random_.below(next_ - first - 1)};
  }
  // In rising order but for a few that come out of order, or twice.
  TaskId new_id() {
    ++next_;
    return random_.chance(0.1) ? id() : TaskId{next_};
  }
  // New ones come up, so that conditions on messages stay open.
  std::string message() { return "m" + std::to_string(next_ / 6 + random_.below(3)); }
  std::string uav() { return one_of<std::string>({"marvin", "heliv", "karma"}); }

  Literal literal(double at) {
    Literal l;
    const double kind = random_.uniform();
    if (kind < 0.7) {
      l.condition = TaskInState{id_before(), static_cast<TaskState>(random_.below(6))};
    } else if (kind < 0.85) {
      l.condition = MessageReceived{message()};
    } else {
      const double instant = at + static_cast<double>(random_.below(12)) - 2;
      l.condition = TimeIs{MissionTime::seconds(instant), random_.chance(0.6)};
    }
    l.negated = random_.chance(0.25);
    l.modality = random_.chance(0.5) ? Modality::kOptional : Modality::kMandatory;
    return l;
  }
  Formula formula(double at) {
    Formula f(random_.below(4));
    for (Clause& clause : f) {
      const std::uint64_t size = random_.chance(0.02) ? 0 : 1 + random_.below(3);
      for (std::uint64_t i = 0; i < size; ++i) clause.push_back(literal(at));
    }
    return f;
  }
  std::vector<std::string> uavs() {
    std::vector<std::string> names(random_.below(4));
    for (std::string& name : names) name = uav();
    return names;
  }
  Task task(double at) {
    Task t;
    t.id = new_id();
    t.type = one_of<std::string>(
        {"takeoff", "goto", "takeshot", "wait", "land", "synchronise", "joint:track"});
    if (t.type == "synchronise") {
      t.synchronisation = Synchronisation{1 + random_.below(3), uavs(), uavs(), {}};
      if (random_.chance(0.4)) {
        t.synchronisation->deadline =
            MissionTime::seconds(at + static_cast<double>(random_.below(10)));
      }
    }
    if (random_.chance(0.7)) t.preconditions = formula(at);
    if (random_.chance(0.4)) t.exit = formula(at);
    return t;
  }
  Input input(double at) {
    const double kind = random_.uniform();
    if (kind < 0.30) return Start{task(at), static_cast<InsertionMode>(random_.below(4))};
    if (kind < 0.68) {
      const TaskState state =
          one_of<TaskState>({TaskState::kRunning, TaskState::kRunning, TaskState::kEnded,
                             TaskState::kAborted, TaskState::kStarted, TaskState::kAborting});
      return FunctionalStatus{id(), state, ""};
    }
    if (kind < 0.75) return Abort{id()};
    if (kind < 0.79) return ProcessMessage{message()};
    if (kind < 0.86) {
      UpdateConditions u{id(), {}, {}};
      if (random_.chance(0.6)) u.preconditions = formula(at);
      if (random_.chance(0.6)) u.exit = formula(at);
      return u;
    }
    if (kind < 0.89) return Suppress{id()};
    if (kind < 0.95) return SyncReceived{1 + random_.below(3), uav()};
    if (kind < 0.975) return PeerReachable{uav()};
    if (kind < 0.985) return Relinquish{};
    return Tick{};
  }

  Random random_;
  std::uint64_t next_ = 0;
};

}  // namespace skein::executive::testing
