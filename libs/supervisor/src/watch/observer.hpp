// SPDX-License-Identifier: Apache-2.0
// Handles observations of tasks: start, end, abort, refusal; and of the vehicle.
#pragma once

#include <optional>
#include <string>

#include "requests/hand_over.hpp"
#include "watch/contingencies.hpp"
#include "watch/refusals.hpp"
#include "watch/way_watch.hpp"

namespace skein::supervisor {

/// Lifetime: refers to its Rooms.
class Observer {
 public:
  struct Rooms {
    HandOver& hand_over;
    SafeMode& safe_mode;
    Contingencies& contingencies;
    Committer& committer;
    Dates& dates;
    Beliefs& beliefs;
    Agenda& agenda;
    Outbox& out;
    Book& book;
  };
  /// `grace`: by how much a task may fall short of its least duration.
  Observer(const Rooms& rooms, Duration grace);

  void see(const TaskSeen& seen);
  /// The executive answered a request of the supervisor.
  void see(const executive::Reply& reply);
  /// A vehicle state. Returns the devices that have newly failed.
  std::set<std::string> see(const VehicleSeen& seen);

 private:
  MissionTime now() const { return out_.now(); }
  bool engaged() const { return hand_over_.engaged(); }
  void see(Entry& entry, const executive::TaskEvent& event);
  /// `came_back`: another executive had it, or has ended it.
  void see_loose(const executive::TaskEvent& event, bool came_back);
  void note_who_gives_way(TaskId id);
  void see_scheduled(Entry& entry);
  void see_started(Entry& entry);
  void see_ended(Entry& entry);
  void see_aborted(Entry& entry);
  void settle_done(Entry& entry);
  void excuse_if_others_fly_by(const Entry& entry);
  void refused(const Entry& entry, const std::string& what);
  void pause_need(const Entry& entry, int refused);
  bool leaves_closed_air(const Entry& entry) const;
  Duration retry_after(const Loose& loose, const std::string& why);
  void tell_beside_its_times(const Entry& entry, bool ends);
  void tell_progress(GoalId id);
  bool was_stopped_in_time(const Entry& entry) const;
  std::string missed(const Entry& entry) const;
  bool follows_lost_task(const Entry& entry) const;
  bool begins_elsewhere(const Entry& look) const;

  HandOver& hand_over_;
  SafeMode& safe_mode_;
  Contingencies& contingencies_;
  Committer& committer_;
  Dates& dates_;
  Beliefs& beliefs_;
  Agenda& agenda_;
  Outbox& out_;
  Book& book_;
  Duration grace_;
  Refusals refusals_;
  WayWatch ways_;
  bool led_away_ = false;  ///< an operator's task has moved the vehicle since the plan was made
  /// A task that is not the plan's, such as a flight home out of contact, has moved the vehicle
  /// since a motion of the plan did.
  bool moved_by_others_ = false;
};

}  // namespace skein::supervisor
