// SPDX-License-Identifier: Apache-2.0
// Elementary tasks built by hand, Karma's plan of the thesis, and random plans.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/mission/elementary_plan.hpp"

namespace skein::supervisor {

using Tasks = std::vector<mission::ElementaryTask>;

inline executive::TaskId id(std::uint64_t number) { return executive::TaskId(number); }
inline MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

/// a_task(103, "takeshot").running(102).stopped_by(102)
class TaskBuilder {
 public:
  TaskBuilder(std::uint64_t number, const std::string& type) {
    task_.id = id(number);
    task_.type = type;
    task_.name = "task-" + type;
    if (type == "takeshot") task_.parameters.add({"device", "camera", {}});
    if (functional::TaskTypes::shipped().of(type).synchronises()) {
      task_.synchronisation =
          executive::Synchronisation{509 + number, {"karma", "heliv"}, {"karma", "heliv"}, {}};
    }
  }
  TaskBuilder& lasts(double least, double most) {
    task_.duration = {Duration::seconds(least), Duration::seconds(most)};
    return *this;
  }
  TaskBuilder& lasts(double seconds) { return lasts(seconds, seconds); }
  TaskBuilder& ended(std::uint64_t other) {
    return depends(mission::DependenceKind::kEnded, other);
  }
  TaskBuilder& running(std::uint64_t other) {
    return depends(mission::DependenceKind::kRunning, other);
  }
  TaskBuilder& over(std::uint64_t other) { return depends(mission::DependenceKind::kOver, other); }
  TaskBuilder& stopped_by(std::uint64_t other) {
    task_.stop.push_back({mission::DependenceKind::kEnded, id(other)});
    return *this;
  }
  TaskBuilder& open_ended() {
    task_.open_ended = true;
    return *this;
  }
  TaskBuilder& start_before(double s) { return bound(task_.time.start_before, s); }
  TaskBuilder& start_after(double s) { return bound(task_.time.start_after, s); }
  TaskBuilder& end_before(double s) { return bound(task_.time.end_before, s); }
  TaskBuilder& end_after(double s) { return bound(task_.time.end_after, s); }
  operator mission::ElementaryTask() const { return task_; }  // NOLINT: reads as the task it makes

 private:
  TaskBuilder& depends(mission::DependenceKind kind, std::uint64_t other) {
    task_.dependences.push_back({kind, id(other)});
    return *this;
  }
  TaskBuilder& bound(std::optional<MissionTime>& bound, double s) {
    bound = at(s);
    return *this;
  }
  mission::ElementaryTask task_;
};

inline TaskBuilder a_task(std::uint64_t number, const std::string& type) { return {number, type}; }

/// Source: spec 3.5 (figures VI.8, VI.9), with the seed's durations.
inline Tasks karma_plan() {
  return {a_task(100, "takeoff").lasts(4, 6),
          a_task(101, "goto").ended(100).lasts(1, 81),
          a_task(102, "wait").ended(101).lasts(20),
          a_task(103, "takeshot").running(102).stopped_by(102),
          a_task(104, "goto").ended(103).ended(102).lasts(8, 88),
          a_task(105, "goto").ended(104).lasts(300),
          a_task(106, "takeshot").running(105).ended(103).stopped_by(105),
          a_task(107, "goto").ended(106).ended(105).lasts(8, 98),
          a_task(108, "land").ended(107).lasts(4, 6)};
}

/// Source: spec 3.5 (figures VI.11, VI.13).
inline Tasks marvin_plan() {
  return {a_task(40, "goto").lasts(2, 72),
          a_task(41, "wait").ended(40).lasts(0, 0).stopped_by(42),
          a_task(42, "synchronise").running(41).lasts(0, 30),
          a_task(43, "wait").ended(41).lasts(120),
          a_task(44, "takeshot").running(43).ended(42).stopped_by(43),
          a_task(45, "goto").ended(44).ended(43).lasts(2, 92),
          a_task(46, "land").ended(45).lasts(4, 6)};
}

/// Chains of motion with takeshots beside them, meetings with another UAV, joint tasks of their own
/// that takeshots may wait for (`odd`), and absolute constraints.
Tasks random_plan(Random& random, bool odd);

/// A long plan as missions give it: flights with takeshots, waits and a landing, so many tasks.
Tasks long_plan(std::size_t tasks);

}  // namespace skein::supervisor
