// SPDX-License-Identifier: Apache-2.0
// MPS: plays the scripted ground side of a mission.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "skein/ground_orders/messages.hpp"
#include "skein/ground_orders/operator_request.hpp"
#include "skein/ground_orders/script.hpp"
#include "skein/ground_station/plan_interrupted.hpp"
#include "skein/world/terrain.hpp"

namespace skein::ground_station {

/// Steps and scripted operator actions wait concurrently for their triggers. When a trigger has
/// occurred, and the delay after it has passed, the actions are done in order, and then the step
/// counts as done for the triggers of others (OnStep). Of several that are due, the earliest goes
/// first; at one instant, operators before steps, then in the order written. Triggers work alike at
/// all degrees of the UAVs.
///
/// Targets refer to the mission's subject alarm: the alarm of the OnAlarm in the step last done
/// that has one, with its latest estimate; before any such step, the first alarm raised. A step's
/// targets are resolved when it is done; a task or a mission whose target cannot be resolved is not
/// sent (anomaly).
///
/// Deterministic. Not safe to share between threads. Cost of an input: O(armed triggers of the
/// script, except those that wait only for a future instant). Source: T VI.1.1, VI.1.3 (the ground
/// sent task lists with their dependencies), spec 8.1.
class MissionPlanning {
 public:
  using Input =
      std::variant<Tick, AlarmEvent, AlarmRefined, TaskChanged, UavRestarted, PeerReachable,
                   CommandChanged, OperatorActs, DoActions, DegreeChanged, GoalChanged,
                   MissionChanged, TeamTaskChanged, GlobalMissionChanged, PlanInterrupted>;
  using Effect = std::variant<IssueCommand, IssueToAll, AbortEverything, ChangeHands, ResumeHeld,
                              DropHeld, PhaseEntered, OperatorDid, StepDone, MissionFinished,
                              GiveGlobalMission, DeclareLost, DeclareFound, PlayRole, Anomaly>;

  /// Precondition: problems_of(script) is empty. The terrain must outlive this.
  MissionPlanning(Script script, const world::Terrain& terrain);
  MissionPlanning(const MissionPlanning&) = delete;  // it points into its own script
  MissionPlanning(MissionPlanning&&) = default;

  std::vector<Effect> handle(const Input& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const { return wakeup_; }

  /// The operator actions (OnOperator) that armed steps wait for, in the order written.
  std::vector<std::string> answers() const;

  bool finished() const { return finished_; }
  const std::string& phase() const { return phase_; }

 private:
  /// One leaf of a trigger, and whether it has happened since its step was armed.
  struct Leaf {
    const Trigger* trigger;
    std::optional<MissionTime> at;
    AlarmId alarm;  ///< of an OnAlarm that has happened
    /// For triggers that last (a passed instant, a silence): it had occurred when the step was last
    /// done, and does not trigger it again.
    bool used = false;
  };
  /// A step or an operator action.
  struct Waiting {
    const Trigger* when;
    Duration after;
    const Step* step = nullptr;
    const OperatorAction* operator_action = nullptr;
    std::vector<Leaf> leaves;  ///< in the order written
    bool armed = true;
    std::optional<MissionTime> not_before;  ///< of a step that was done and armed again
  };
  using Effects = std::vector<Effect>;

  void begin(Waiting waiting);
  void wake(MissionTime now);
  template <class What, class Matches>
  void mark(MissionTime at, const Matches& matches);
  void mark_instants(MissionTime now);
  /// When the leaf occurs by the passing of time; absent: not so.
  std::optional<MissionTime> instant_of(const Leaf& leaf) const;
  /// Since when there has been no contact with the UAV; absent: there is contact.
  std::optional<MissionTime> silent_since(const std::string& uav) const;
  void note_contact(const PeerReachable& contact, MissionTime now);
  void note(const Input& input, MissionTime now, Effects& effects);
  void note_autonomy(const Input& input, MissionTime now);
  void note_alarm(const Alarm& alarm, MissionTime now);
  void note_operator(const std::string& does, MissionTime now, Effects& effects);
  std::optional<MissionTime> due(const Waiting& waiting) const;
  std::optional<MissionTime> first_instant() const;
  Waiting* next_due(MissionTime now);
  void fire(Waiting& waiting, MissionTime now, Effects& effects);
  /// In their order, until one ends the mission.
  void perform(const std::vector<Action>& actions, const std::string& asked_by, MissionTime now,
               Effects& effects);
  const Alarm* subject() const;

  Script script_;
  const world::Terrain& terrain_;
  /// Waiting operator actions and steps, by rank: operator actions, then steps, in the order
  /// written.
  std::map<std::size_t, Waiting> awake_;
  /// Those that wait only for an instant, by instant and rank.
  std::map<std::pair<MissionTime, std::size_t>, Waiting> asleep_;
  /// Since when there has been no contact, by UAV; absent: there is contact.
  std::map<std::string, std::optional<MissionTime>> silent_since_;
  std::map<AlarmId, Alarm> alarms_;
  AlarmId subject_;
  std::string phase_;
  bool finished_ = false;
  std::optional<MissionTime> wakeup_;  ///< cached after each input, since a script may be long
};

}  // namespace skein::ground_station
