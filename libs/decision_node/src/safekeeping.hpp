// SPDX-License-Identifier: Apache-2.0
// What the UAV does by itself: out of contact, or interrupted in the air.
#pragma once

#include <optional>
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
  /// Carries out the contact-loss policy when its instant has come.
  void time_passes();
  std::optional<MissionTime> next_wakeup() const;

  /// Makes the vehicle hold, or come home, as soon as nothing of the ground's is under way.
  void keep(ContactPolicy how);
  /// Something of the ground's may be over.
  void start_pending();
  void own_task_over(const executive::TaskEvent& event);
  /// Of its own tasks. When one of others takes the place of an own one that was under way, what
  /// was to follow that (a landing) would begin in its stead, and be aborted at once.
  void withdraw_what_waits();
  /// A hold ends before the vehicle cannot come home any more, and air that closes around it is
  /// left: the ground may be silent, or have forgotten it.
  void look_after(const world::Telemetry& telemetry);

 private:
  void carry_out_policy();
  void hold();
  void come_home();
  void come_home_again();
  void leave_closed_air(const world::Vector3& at);
  void warn_of_energy(const world::Telemetry& telemetry);
  bool must_return(const world::Telemetry& telemetry) const;
  bool may_be_on_its_way() const;
  bool is_idle() const;
  bool is_left_alone() const;
  bool knows_world() const;
  std::vector<world::Vector3> way_to(const world::Vector3& home,
                                     const std::optional<world::Vector3>& from) const;
  void go(const std::vector<world::Vector3>& way, executive::InsertionMode mode);

  Core& core_;
  ContactWatch contact_;
  std::optional<world::Vector3> seen_at_, leaves_to_;
  std::optional<ContactPolicy> pending_;  ///< until nothing of the ground's is under way
  /// When its own way home is tried again, after the vehicle gave it up: with growing pauses.
  std::optional<MissionTime> again_at_;
  Duration pause_;
  /// The policy's instant came on the ground; a takeoff that was given before may come after it.
  bool owed_ = false;
  /// Those who fly it are told that its energy is short: once a flight, looked at now and then.
  bool warned_ = false;
  MissionTime looked_at_energy_;
  bool holds_ = false;  ///< by itself, as long as the energy lasts to come home after it
};

}  // namespace skein::decision_node
