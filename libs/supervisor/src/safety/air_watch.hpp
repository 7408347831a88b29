// SPDX-License-Identifier: Apache-2.0
// Reacts to closed air: across a way, at the place of a task, or around the UAV.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "book/own_goals.hpp"
#include "commitment/committer.hpp"
#include "jobs/agenda.hpp"
#include "watch/beliefs.hpp"

namespace skein::supervisor {

/// Lifetime: refers to its arguments.
class AirWatch {
 public:
  AirWatch(const Beliefs& beliefs, OwnGoals& own_goals, Committer& committer, Agenda& agenda,
           Outbox& out, Book& book);

  /// Stops every goal that would meet closed air; the first of them counts as failed. A UAV in
  /// closed air stops all its tasks and first leaves the air.
  void check(const std::string& cause);
  /// The same if the UAV is found waiting in closed air: because of a task that was stopped, or by
  /// its waiting circle. At most once a minute.
  void look();
  /// The same for air that closes within kWarning.
  void watch();
  /// The next instant at which watch() has to act.
  std::optional<MissionTime> next_closing() const;

 private:
  MissionTime now() const { return out_.now(); }
  bool is_met(const Entry& entry, const world::Volume& volume) const;
  bool goes_through(const Entry& entry, const world::Volume& volume) const;
  bool circles_into(const world::Vector3& end, const world::Volume& volume) const;
  bool strays_into(const std::vector<world::Vector3>& way, const world::Volume& volume) const;
  bool swings_into(const std::vector<world::Vector3>& rest, const world::Volume& volume) const;
  bool stays_in(const Entry& entry, const world::Volume& volume) const;
  const world::Volume* met_by(const Entry& entry) const;
  const world::Volume* closed_around(bool stops) const;
  bool is_leaving() const;
  bool is_nearly_down() const;
  std::vector<GoalId> goals_met(std::string& what) const;

  const Beliefs& beliefs_;
  OwnGoals& own_goals_;
  Committer& committer_;
  Agenda& agenda_;
  Outbox& out_;
  Book& book_;
  MissionTime looked_ = MissionTime::seconds(-1000);  ///< when look() last found it in closed air
  MissionTime watched_;                               ///< closings up to then have been handled
};

}  // namespace skein::supervisor
