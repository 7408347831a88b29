// SPDX-License-Identifier: Apache-2.0
// Dispatch of tasks to the functional layer, and the ground station's tasks under way there.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "bus.hpp"

namespace skein::decision_node {

class Merging;
class OwnTasks;

/// The functional layer executes one moving task at a time: a task that moves or holds the vehicle
/// waits until own tasks, which give way, and interrupted tasks are over. To what the executive on
/// board asks for, tasks give way that the ground has not given back: motions to a motion, and what
/// uses a device to what uses it next. With plan merging a moving task then waits for its
/// reservation.
class Vehicle {
 public:
  Vehicle(Bus& bus, OwnTasks& own_tasks, Merging& merging)
      : bus_(bus), own_tasks_(own_tasks), merging_(merging) {}

  void dispatch(functional::Request request);
  /// Sends the request to the functional layer. Precondition: it waits for nothing.
  void begin(functional::Request request);
  /// Interrupts a task. Returns its final status if it was not dispatched yet; otherwise the
  /// functional layer is asked and will answer.
  std::optional<functional::Status> interrupt(functional::TaskId task);
  /// A status of the functional layer for a task dispatched here.
  void told(const functional::Status& status);
  /// Dispatched tasks whose end was not reported yet.
  std::vector<functional::TaskId> under_way() const;
  /// For a functional layer that may have forgotten the task: dispatches it again if it is `wanted`
  /// and can begin anew, otherwise interrupts it. Precondition: it is under way.
  void ask_again(functional::TaskId task, bool wanted);
  /// Dispatches the waiting tasks that may go now.
  void release();

  // ---- tasks under way that the ground's executive has, not this one ----

  /// Notes such a task; false: it was known already.
  bool ground_has(functional::TaskId task, const std::string& type);
  /// The executive on board has the task from now on.
  void ground_has_no_more(functional::TaskId task) { of_ground_.erase(task); }
  bool is_of_ground(functional::TaskId task) const { return of_ground_.contains(task); }
  const std::map<functional::TaskId, std::string>& of_ground() const { return of_ground_; }
  /// Passes the status on to the ground. Returns the task's type; empty: unknown.
  std::string pass_on(const functional::Status& status);

 private:
  struct UnderWay {
    functional::Request request;
    bool interrupted = false;
  };

  bool must_wait(const functional::Request& request) const;
  /// Tasks of the ground under way that exclude what the executive on board asks for.
  std::vector<functional::TaskId> in_the_way(const functional::Request& request) const;
  void stop(functional::TaskId task);

  Bus& bus_;
  OwnTasks& own_tasks_;
  Merging& merging_;
  std::vector<functional::Request> waiting_;
  std::map<functional::TaskId, UnderWay> under_way_;
  std::set<functional::TaskId> holding_;  ///< tasks under way that move or hold the vehicle
  std::set<functional::TaskId> ending_;   ///< those of `holding_` that were interrupted
  std::map<functional::TaskId, std::string> of_ground_;
};

}  // namespace skein::decision_node
