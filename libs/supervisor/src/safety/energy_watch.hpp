// SPDX-License-Identifier: Apache-2.0
// What the UAV really holds, against what its plan and the way home still take.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "safety/safe_mode.hpp"

namespace skein::supervisor {

/// Gives up what is only planned, then what is in hand; comes down at once as the last of all.
/// Lifetime: refers to its arguments.
class EnergyWatch {
 public:
  EnergyWatch(const Beliefs& beliefs, SafeMode& safe_mode, Committer& committer, Agenda& agenda,
              Outbox& out, Book& book);

  /// Told once; again only after what remains fitted with some room. It is asked with every state
  /// of the vehicle: flights are flown in thought only where a rough sum does not fit already.
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
  bool told_ = false;
};

}  // namespace skein::supervisor
