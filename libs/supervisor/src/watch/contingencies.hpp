// SPDX-License-Identifier: Apache-2.0
// Operator 6 before its job: observations shift the dates of the plan, or break it.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "commitment/committer.hpp"
#include "jobs/agenda.hpp"
#include "skein/world/geometry.hpp"
#include "watch/beliefs.hpp"

namespace skein::supervisor {

/// The first two steps of repair, absorb and shift; and the bookkeeping of failed and cancelled
/// goals, before a job plans the rest. Lifetime: refers to its arguments.
class Contingencies {
 public:
  /// `grace`: by how much promised dates may move; `refinements`: how often a failed goal is
  /// refined again.
  struct Limits {
    Duration grace;
    int refinements = 2;
  };
  struct Rooms {
    const Beliefs& beliefs;
    Dates& dates;
    Committer& committer;
    Agenda& agenda;
    Outbox& out;
    Book& book;
  };
  Contingencies(Limits limits, const Rooms& rooms);

  // ---- dates ----

  /// Updates the dates after an observation; a conflict in the network is a contingency.
  void check_network(const std::string& cause);
  /// The same after news of partners; the UAV gives way if partners wait for each other.
  void check_meetings();
  /// Keeps the promised dates, or promises new ones. Source: spec 6.2 (6).
  void absorb_or_shift(const std::string& cause);
  /// Handles tasks that should have started or ended by now.
  void check_slips();

  // ---- goals ----

  /// The goal failed: it is refined again from here if its number of refinements permits.
  void fail_goal(GoalId id, const std::string& cause);
  void cancel_goal(GoalId id, const std::string& cause);
  /// Goals fail that need one of the devices `newly` failed.
  void check_devices(const std::set<std::string>& newly);
  /// A place turned out to be `moved` [m] from where it was believed: goals about it are planned
  /// again; perceptions made so far count. A task under way goes on while it still has the place in
  /// view; displacements add up. From near by, that is less than from far above, and none where the
  /// ground comes between. Precondition: the beliefs have the place where it turned out to be.
  void look_elsewhere(const std::string& place, const world::Vector3& moved,
                      const std::string& cause);
  /// Whether tasks that are given look at the place from where the ground would hide it there.
  bool loses_sight_of(const std::string& place, const world::Vector3& now) const;

 private:
  /// A perception that is not over.
  struct Look {
    world::Vector3 eye;  ///< where it looks from or will [m]
    const world::SensorModel* sensor;
  };
  MissionTime now() const { return out_.now(); }
  void check_dates(const std::string& cause, Duration tolerance);
  void give_way();
  bool is_out_of_view(GoalId goal, const std::string& place, const world::Vector3& moved);
  /// Those of the goal that are aimed at the place.
  std::vector<Look> looks_at(GoalId goal, const world::Vector3& place) const;
  bool is_aimed_past(GoalId goal, const world::Vector3& before, const world::Vector3& now) const;

  Limits limits_;
  const Beliefs& beliefs_;
  Dates& dates_;
  Committer& committer_;
  Agenda& agenda_;
  Outbox& out_;
  Book& book_;
  std::string risk_told_;
  /// Displacement of each goal's place since the goal was given to the executive [m].
  std::map<GoalId, world::Vector3> moved_;
};

}  // namespace skein::supervisor
