// SPDX-License-Identifier: Apache-2.0
// The way to the functional layer, and what is under way there for the ground station.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "bus.hpp"

namespace skein::decision_node {

class Merging;
class OwnTasks;

/// The functional layer moves for one task at a time: what is to hold the vehicle waits until own
/// tasks, which give way, and tasks that were interrupted are over. What moves it then waits for
/// its air, where ways are merged.
class Vehicle {
 public:
  Vehicle(Bus& bus, OwnTasks& own_tasks, Merging& merging)
      : bus_(bus), own_tasks_(own_tasks), merging_(merging) {}

  void dispatch(functional::Request request);
  /// It has all that it waited for.
  void begin(functional::Request request);
  /// The status to take when the task had not been dispatched yet; else the functional layer is
  /// asked, and answers.
  std::optional<functional::Status> interrupt(functional::TaskId task);
  /// From the functional layer, of a task dispatched here.
  void told(const functional::Status& status);
  /// What the functional layer was asked for and has not said the end of.
  std::vector<functional::TaskId> under_way() const;
  /// It may have forgotten the task: it is asked for once more if it can begin anew and is wanted,
  /// else interrupted. Precondition: it is under way.
  void ask_again(functional::TaskId task, bool wanted);
  /// What waited goes, if it may.
  void release();

  // ---- the ground's tasks that are under way and not in the executive ----

  /// False: it was known already.
  bool ground_has(functional::TaskId task, const std::string& type);
  /// The executive has it from now on.
  void ground_has_no_more(functional::TaskId task) { of_ground_.erase(task); }
  bool is_of_ground(functional::TaskId task) const { return of_ground_.contains(task); }
  const std::map<functional::TaskId, std::string>& of_ground() const { return of_ground_; }
  /// Passed on; the task's type, empty when it is not known.
  std::string pass_on(const functional::Status& status);

 private:
  struct UnderWay {
    functional::Request request;
    bool interrupted = false;
  };

  bool must_wait(const functional::Request& request) const;
  void stop(functional::TaskId task);

  Bus& bus_;
  OwnTasks& own_tasks_;
  Merging& merging_;
  std::vector<functional::Request> waiting_;
  std::map<functional::TaskId, UnderWay> under_way_;
  std::set<functional::TaskId> holding_;  ///< tasks that hold the vehicle, under way there
  std::set<functional::TaskId> ending_;   ///< of these, the ones that were interrupted
  std::map<functional::TaskId, std::string> of_ground_;
};

}  // namespace skein::decision_node
