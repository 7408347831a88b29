// SPDX-License-Identifier: Apache-2.0
// Keeps the vehicle safe by itself: out of contact with the ground, or interrupted in the air.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bus.hpp"
#include "skein/decision_node/config.hpp"

namespace skein::decision_node {

class Core;

class Safekeeping {
 public:
  explicit Safekeeping(Core& core);

  void ground_heard(bool reachable, MissionTime now) {
    contact_.ground_heard(reachable, now);
    owed_ = owed_ && !reachable;
  }
  /// Carries out the contact-loss policy when it is due.
  void time_passes();
  std::optional<MissionTime> next_wakeup() const;

  /// Makes the vehicle hold or come home, as soon as no task of the ground is under way.
  void keep(ContactPolicy how);
  /// Starts what keep() asked for, if no task of the ground is under way any more.
  void start_pending();
  void own_task_over(const executive::TaskEvent& event);
  /// Aborts own tasks that have not begun. Otherwise, when a task of others displaces the own task
  /// under way, its successor (a landing) would begin in its place, and be aborted at once.
  void withdraw_what_waits();
  /// Ends a hold while the energy still lasts to come home, and leaves air that closes around the
  /// vehicle: the ground may be silent, or have forgotten the vehicle.
  void look_after(const world::Telemetry& telemetry);

 private:
  void carry_out_policy();
  void stop_plan();
  /// What was interrupted of `before`, if nothing else has it: somebody may give it again.
  void give_back(const std::vector<mission::HeldTask>& before);
  void hold();
  void come_home();
  void come_home_again();
  void look_ahead(const world::Vector3& at);
  void leave_closed_air(const world::Vector3& at);
  void warn_of_closed_air(const world::Vector3& at);
  void warn_of_energy(const world::Telemetry& telemetry);
  void warn_of_idling();
  bool must_return(const world::Telemetry& telemetry) const;
  bool may_be_on_its_way() const;
  bool has_nothing_to_do() const;
  bool is_idle() const;
  bool is_left_alone() const;
  bool knows_world() const;
  world::Vector3 over_landing_place(const world::Vector3& pad) const;
  std::vector<world::Vector3> way_to(const world::Vector3& home,
                                     const std::optional<world::Vector3>& from) const;
  void go(const std::vector<world::Vector3>& way, executive::InsertionMode mode);

  Core& core_;
  ContactWatch contact_;
  std::optional<world::Vector3> seen_at_, leaves_to_;
  std::vector<world::Vector3> way_home_;       ///< while the vehicle is on it
  std::vector<world::Volume> way_home_among_;  ///< the volumes that it was last looked at among
  std::optional<ContactPolicy> pending_;       ///< waits until no task of the ground is under way
  /// When to try the way home again after the vehicle gave it up; pauses grow.
  std::optional<MissionTime> again_at_;
  Duration pause_;
  /// The policy came due on the ground; a takeoff that was given before may still follow.
  bool owed_ = false;
  /// The warning that the energy is short was given in this flight; ever, where it drives.
  bool warned_ = false;
  /// When it says that it is in the air with nothing under way; nothing: there is something.
  std::optional<MissionTime> says_it_idles_;
  std::map<std::string, MissionTime> closed_around_;  ///< volumes, and until when it was in each
  MissionTime looked_at_energy_;
  bool holds_ = false;  ///< holds by itself, until it has to come home for its energy
};

}  // namespace skein::decision_node
