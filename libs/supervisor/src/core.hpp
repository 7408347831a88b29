// SPDX-License-Identifier: Apache-2.0
// Composition of the supervisor's components, and the dispatch of inputs to them.
#pragma once

#include <optional>

#include "book/own_goals.hpp"
#include "commitment/committer.hpp"
#include "jobs/jobs.hpp"
#include "requests/requests.hpp"
#include "safety/air_watch.hpp"
#include "safety/energy_watch.hpp"
#include "watch/observer.hpp"

namespace skein::supervisor {

/// Each component refers only to members declared before it: those that its constructor takes.
class Supervisor::Core {
 public:
  explicit Core(Config config);
  Effects handle(const Input& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;
  bool engaged() const { return hand_over_.engaged(); }
  const mission::PlanReport& report() const { return out_.report(); }
  std::shared_ptr<const world::World> world() const { return beliefs_.shared_world(); }
  bool loses_sight_of(const std::string& place, const world::Vector3& now) const {
    return engaged() && contingencies_.loses_sight_of(place, now);
  }
  bool has_given_up(executive::TaskId task) const {
    const Entry* entry = book_.find(task);
    return engaged() && entry != nullptr && entry->over();
  }
  std::optional<mission::HighLevelTask> goal(GoalId id) const {
    const auto known = book_.goals.find(id);
    return known == book_.goals.end() ? std::nullopt : std::optional(known->second.task);
  }

 private:
  MissionTime now() const { return out_.now(); }
  void on(const AddMission& input) { requests_.add(input.mission); }
  void on(const CancelMission& input) { requests_.cancel(input); }
  void on(const Disengage& input) { hand_over_.give_up(input); }
  void on(const Engage& input);
  void on(const WorldChanged& input);
  void on(const TaskSeen& input) { observer_.see(input); }
  void on(const RequestAnswered& input) { observer_.see(input.reply); }
  void on(const VehicleSeen& input);
  void on(const JobFinished& input) { jobs_.finished(input); }
  void on(const JointTaskDue& input) { committer_.joint_tasks().due(input); }
  void on(const JointTaskAnswered& input);
  void on(const PartnersSeen& input);
  void on(const OrdersSeen& input);
  void on(const LivesAgain&);
  void on(const Tick&) {}

  void tell_frontier();

  Config config_;
  Book book_;
  Beliefs beliefs_;
  Outbox out_;
  OwnGoals own_goals_;
  Dates dates_;
  Agenda agenda_;
  Committer committer_;
  Contingencies contingencies_;
  SafeMode safe_mode_;
  AirWatch air_;
  EnergyWatch energy_;
  Situations situations_;
  TrueGoals true_goals_;
  Results results_;
  Jobs jobs_;
  HandOver hand_over_;
  Observer observer_;
  Requests requests_;
  temporal::Frontier told_;         ///< the last FrontierChanged
  std::uint64_t told_version_ = 0;  ///< Dates::version() at that time
};

}  // namespace skein::supervisor
