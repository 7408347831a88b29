// SPDX-License-Identifier: Apache-2.0
// Compares the UAV's energy with what its plan and the way home still need.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "safety/safe_mode.hpp"

namespace skein::supervisor {

/// If energy is short, gives up goals that are only planned, then those in hand; the last resort is
/// an immediate landing. Lifetime: refers to its arguments.
class EnergyWatch {
 public:
  EnergyWatch(const Beliefs& beliefs, SafeMode& safe_mode, Committer& committer, Agenda& agenda,
              Outbox& out, Book& book);

  /// Called with every vehicle state. Reacts once to a shortage, and again after the energy was
  /// sufficient with some margin, or once clearly more is missing. Simulates flights only if a
  /// cheap upper bound is not sufficient.
  void check();

 private:
  MissionTime now() const { return out_.now(); }
  Retreat retreat() const { return beliefs_.retreat(now()); }
  Whereabouts end_of(const std::vector<mission::ElementaryTask>& tasks) const;
  double in_hand() const;
  double wanted(const Retreat& retreat) const;
  void run_short(double wanted);
  void give_up(const std::set<GoalId>& in_hand, const std::string& cause);
  void divert(const std::string& cause);
  std::optional<GoalId> waiting_in(const std::set<GoalId>& goals) const;
  bool comes_down() const;
  void come_down_at_once();
  void bring_down(std::optional<GoalId> waiting, const std::string& cause);

  const Beliefs& beliefs_;
  SafeMode& safe_mode_;
  Committer& committer_;
  Agenda& agenda_;
  Outbox& out_;
  Book& book_;
  std::optional<double> told_;  ///< so much was missing when it last reacted
};

}  // namespace skein::supervisor
