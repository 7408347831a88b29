// SPDX-License-Identifier: Apache-2.0
// Air that is closed: across a way, where a task keeps the UAV, or around it.
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

  /// Every goal that would meet closed air is stopped; the first of them counts as failed. A UAV in
  /// closed air stops all that it does and leaves first.
  void check(const std::string& cause);
  /// Likewise, when it has come to stay in closed air: carried there by what it stopped, or on a
  /// circle that was far from it. Once a minute.
  void look();
  /// Likewise, when air is to close so soon that what is in it must leave.
  void watch();
  /// The next instant at which it is.
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
  MissionTime looked_ = MissionTime::seconds(-1000);  ///< when it last was found in closed air
  MissionTime watched_;                               ///< closings before this have been dealt with
};

}  // namespace skein::supervisor
