// SPDX-License-Identifier: Apache-2.0
// Operator 6 before its job: what is seen moves the dates of the plan, or breaks it.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "commitment/committer.hpp"
#include "jobs/agenda.hpp"
#include "skein/world/geometry.hpp"

namespace skein::supervisor {

/// The first two rungs of repair, absorb and shift; and what a goal loses when it fails or is
/// cancelled, so that a job may plan the rest. Lifetime: refers to its arguments.
class Contingencies {
 public:
  /// `grace`: how far dates may move that were promised; `refinements`: times that a failed goal is
  /// refined again.
  struct Limits {
    Duration grace;
    int refinements = 2;
  };
  Contingencies(Limits limits, Dates& dates, Committer& committer, Agenda& agenda, Outbox& out,
                Book& book);

  // ---- dates ----

  /// The dates after something was seen; what breaks the network is a contingency.
  void check_network(const std::string& cause);
  /// Likewise, after news of those whom the UAV is to meet; it gives way where each waits for the
  /// other.
  void check_meetings();
  /// The promised dates hold, or others are promised. Source: spec 6.2 (6).
  void absorb_or_shift(const std::string& cause);
  /// What should have started or ended by now is looked at.
  void check_slips();

  // ---- goals ----

  /// It is refined again from here as often as that is allowed.
  void fail_goal(GoalId id, const std::string& cause);
  void cancel_goal(GoalId id, const std::string& cause);
  /// Goals that need one of these, which work no more, fail.
  void check_devices(const std::set<std::string>& newly);
  /// A place turned out to lie elsewhere than it was thought [m]: plans for it are made again; what
  /// was seen there counts. What is under way goes on while it still has the place in view, however
  /// often that has moved since.
  void look_elsewhere(const std::string& place, const world::Vector3& moved,
                      const std::string& cause);

 private:
  MissionTime now() const { return out_.now(); }
  void check_dates(const std::string& cause, Duration tolerance);
  void give_way();
  bool is_out_of_view(GoalId goal, const world::Vector3& moved);

  Limits limits_;
  Dates& dates_;
  Committer& committer_;
  Agenda& agenda_;
  Outbox& out_;
  Book& book_;
  std::string risk_told_;
  /// How far what a goal is about has moved since the goal was given to the executive.
  std::map<GoalId, world::Vector3> moved_;
};

}  // namespace skein::supervisor
