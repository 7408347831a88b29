// SPDX-License-Identifier: Apache-2.0
// The script player.
#include "skein/ground_station/mission_planning.hpp"

#include <algorithm>

#include "script_actions.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::ground_station {
namespace {

constexpr Duration kRest = Duration::milliseconds(1'000);  // of a step that is armed again
// Later than by this a ground station that runs does not wake: then it was away itself.
constexpr Duration kWakesWithin = Duration::milliseconds(2'000);

template <class Leaf>
void collect_leaves(const Trigger& trigger, std::vector<Leaf>& leaves) {
  if (const auto* all = std::get_if<AllOf>(&trigger.what)) {
    for (const Trigger& inner : all->of) collect_leaves(inner, leaves);
  } else if (const auto* any = std::get_if<AnyOf>(&trigger.what)) {
    for (const Trigger& inner : any->of) collect_leaves(inner, leaves);
  } else {
    leaves.push_back({&trigger, std::nullopt, AlarmId(), false});
  }
}

// When a trigger came about, and whether by something its step has not been done for yet.
struct Standing {
  MissionTime at;
  bool fresh = true;
};

// Of what makes up an AnyOf: fresh before used, then the earliest.
bool counts_before(const Standing& a, const Standing& b) {
  return a.fresh != b.fresh ? a.fresh : a.at < b.at;
}

// `leaf` walks over the leaves in the order they were collected.
template <class Iterator>
std::optional<Standing> standing_of(const Trigger& trigger, Iterator& leaf) {
  if (const auto* all = std::get_if<AllOf>(&trigger.what)) {
    Standing standing{MissionTime(), all->of.empty()};
    bool complete = true;
    for (const Trigger& inner : all->of) {
      const std::optional<Standing> part = standing_of(inner, leaf);
      complete = complete && part;
      if (part) standing = {std::max(standing.at, part->at), standing.fresh || part->fresh};
    }
    return complete ? std::optional(standing) : std::nullopt;
  }
  if (const auto* any = std::get_if<AnyOf>(&trigger.what)) {
    std::optional<Standing> standing;
    for (const Trigger& inner : any->of) {
      const std::optional<Standing> part = standing_of(inner, leaf);
      if (part && (!standing || counts_before(*part, *standing))) standing = part;
    }
    return standing;
  }
  const auto& it = *leaf++;
  return it.at ? std::optional(Standing{*it.at, !it.used}) : std::nullopt;
}

template <class What>
const What* as(const Trigger& trigger) {
  return std::get_if<What>(&trigger.what);
}

}  // namespace

MissionPlanning::MissionPlanning(Script script, const world::Terrain& terrain)
    : script_(std::move(script)), terrain_(terrain) {
  SKEIN_EXPECTS(problems_of(script_).empty());
  for (const OperatorAction& action : script_.operators) {
    begin({&action.when, action.after, nullptr, &action, {}, true, {}});
  }
  for (const Step& step : script_.steps) {
    begin({&step.when, step.after, &step, nullptr, {}, true, {}});
  }
  wakeup_ = first_instant();
}

// Nothing but time can wake who waits for instants alone.
void MissionPlanning::begin(Waiting waiting) {
  collect_leaves(*waiting.when, waiting.leaves);
  std::optional<MissionTime> first;
  bool only_instants = true;
  for (const Leaf& leaf : waiting.leaves) {
    const auto* time = as<AtTime>(*leaf.trigger);
    only_instants = only_instants && time != nullptr;
    if (time != nullptr) first = earliest(first, time->at);
  }
  const std::size_t rank = awake_.size() + asleep_.size();
  if (first && only_instants) {
    asleep_.emplace(std::pair(*first, rank), std::move(waiting));
  } else {
    awake_.emplace(rank, std::move(waiting));
  }
}

void MissionPlanning::wake(MissionTime now) {
  while (!asleep_.empty() && asleep_.begin()->first.first <= now) {
    const auto one = asleep_.begin();
    awake_.emplace(one->first.second, std::move(one->second));
    asleep_.erase(one);
  }
}

std::vector<MissionPlanning::Effect> MissionPlanning::handle(const Input& input, MissionTime now) {
  Effects effects;
  wake(now);
  mark_instants(now);
  note(input, now, effects);
  while (Waiting* waiting = next_due(now)) fire(*waiting, now, effects);
  std::erase_if(awake_, [](const auto& one) { return !one.second.armed; });
  wakeup_ = first_instant();
  return effects;
}

std::optional<MissionTime> MissionPlanning::first_instant() const {
  std::optional<MissionTime> wakeup;
  if (finished_) return wakeup;
  if (!asleep_.empty()) wakeup = asleep_.begin()->first.first;
  for (const auto& [rank, waiting] : awake_) {
    if (!waiting.armed) continue;
    wakeup = earliest(wakeup, due(waiting));
    for (const Leaf& leaf : waiting.leaves)
      if (!leaf.at) wakeup = earliest(wakeup, instant_of(leaf));
  }
  return wakeup;
}

// Remembers what happened in every armed step and operator action that waits for it.
template <class What, class Matches>
void MissionPlanning::mark(MissionTime at, const Matches& matches) {
  for (auto& [rank, waiting] : awake_) {
    for (Leaf& leaf : waiting.leaves) {
      const What* what = as<What>(*leaf.trigger);
      if (waiting.armed && what != nullptr && !leaf.at && matches(*what)) leaf.at = at;
    }
  }
}

void MissionPlanning::mark_instants(MissionTime now) {
  for (auto& [rank, waiting] : awake_) {
    for (Leaf& leaf : waiting.leaves) {
      const std::optional<MissionTime> instant = leaf.at ? std::nullopt : instant_of(leaf);
      if (!instant || *instant > now) continue;
      const auto* silence = as<OnSilence>(*leaf.trigger);
      if (silence != nullptr && now > *instant + kWakesWithin) {
        silent_since_[silence->uav] = now;
      } else {
        leaf.at = instant;
      }
    }
  }
}

std::optional<MissionTime> MissionPlanning::instant_of(const Leaf& leaf) const {
  if (const auto* time = as<AtTime>(*leaf.trigger)) return time->at;
  const auto* silence = as<OnSilence>(*leaf.trigger);
  const auto since = silence != nullptr ? silent_since(silence->uav) : std::nullopt;
  return since ? std::optional(*since + silence->lasts) : std::nullopt;
}

std::optional<MissionTime> MissionPlanning::silent_since(const std::string& uav) const {
  const auto known = silent_since_.find(uav);
  return known == silent_since_.end() ? MissionTime() : known->second;
}

void MissionPlanning::note_contact(const PeerReachable& contact, MissionTime now) {
  if (!contact.reachable) {
    silent_since_[contact.uav] = silent_since(contact.uav).value_or(now);
    return;
  }
  silent_since_[contact.uav] = std::nullopt;
  for (auto& [rank, waiting] : awake_) {
    for (Leaf& leaf : waiting.leaves) {
      const auto* silence = as<OnSilence>(*leaf.trigger);
      if (silence == nullptr || silence->uav != contact.uav || !leaf.used) continue;
      leaf = {leaf.trigger, std::nullopt, AlarmId(), false};
    }
  }
}

void MissionPlanning::note(const Input& input, MissionTime now, Effects& effects) {
  if (const auto* alarm = std::get_if<AlarmEvent>(&input)) {
    note_alarm(alarm->alarm, now);
  } else if (const auto* refined = std::get_if<AlarmRefined>(&input)) {
    alarms_[refined->alarm.id] = refined->alarm;
  } else if (const auto* task = std::get_if<TaskChanged>(&input)) {
    mark<OnTask>(now, [&](const OnTask& on) {
      return on.uav == task->uav && on.task == task->task && on.state == task->state;
    });
  } else if (const auto* restarted = std::get_if<UavRestarted>(&input)) {
    mark<OnRestart>(now, [&](const OnRestart& on) { return on.uav == restarted->uav; });
  } else if (const auto* contact = std::get_if<PeerReachable>(&input)) {
    note_contact(*contact, now);
  } else if (const auto* command = std::get_if<CommandChanged>(&input)) {
    if (command->state != CommandState::kExpired) return;
    mark<OnExpired>(
        now, [&](const OnExpired& on) { return command->asked_by == asked_by_step(on.step); });
  } else if (const auto* acts = std::get_if<OperatorActs>(&input)) {
    note_operator(acts->does, now, effects);
  } else if (const auto* deed = std::get_if<DoActions>(&input)) {
    perform(deed->actions, deed->asked_by, now, effects);
  } else {
    note_autonomy(input, now);
  }
}

void MissionPlanning::note_autonomy(const Input& input, MissionTime now) {
  if (const auto* degree = std::get_if<DegreeChanged>(&input)) {
    mark<OnDegree>(now, [&](const OnDegree& on) {
      return on.uav == degree->uav && on.degree == degree->degree;
    });
  } else if (const auto* plan = std::get_if<PlanInterrupted>(&input)) {
    mark<OnHeld>(now, [&](const OnHeld& on) { return on.uav == plan->uav; });
  } else if (const auto* goal = std::get_if<GoalChanged>(&input)) {
    mark<OnGoal>(now, [&](const OnGoal& on) {
      return on.uav == goal->uav && on.goal == goal->goal && on.state == goal->state;
    });
  } else if (const auto* mission = std::get_if<MissionChanged>(&input)) {
    mark<OnMission>(now, [&](const OnMission& on) {
      return on.uav == mission->uav && on.mission == mission->mission && on.state == mission->stage;
    });
  } else if (const auto* task = std::get_if<TeamTaskChanged>(&input)) {
    mark<OnTeamTask>(now, [&](const OnTeamTask& on) {
      return on.task == task->standing.task && on.stage == task->standing.stage;
    });
  } else if (const auto* all = std::get_if<GlobalMissionChanged>(&input)) {
    mark<OnGlobalMission>(now, [&](const OnGlobalMission& on) {
      return on.mission == all->mission && on.stage == all->stage;
    });
  }
}

void MissionPlanning::note_alarm(const Alarm& alarm, MissionTime now) {
  alarms_[alarm.id] = alarm;
  if (subject_ == AlarmId()) subject_ = alarm.id;
  const bool ours = alarm.state != AlarmState::kInfirmed || alarm.id == subject_;
  for (auto& [rank, waiting] : awake_) {
    for (Leaf& leaf : waiting.leaves) {
      const auto* on = as<OnAlarm>(*leaf.trigger);
      if (!waiting.armed || on == nullptr || leaf.at || on->state != alarm.state) continue;
      if (on->id == AlarmId() ? !ours : on->id != alarm.id) continue;
      leaf.at = now;
      leaf.alarm = alarm.id;
    }
  }
}

void MissionPlanning::note_operator(const std::string& does, MissionTime now, Effects& effects) {
  effects.emplace_back(OperatorDid{does});
  mark<OnOperator>(now, [&](const OnOperator& on) { return on.does == does; });
}

std::optional<MissionTime> MissionPlanning::due(const Waiting& waiting) const {
  auto leaf = waiting.leaves.begin();
  const std::optional<Standing> standing = standing_of(*waiting.when, leaf);
  if (!standing || !standing->fresh) return std::nullopt;
  const MissionTime at = standing->at + waiting.after;
  return waiting.not_before ? std::max(at, *waiting.not_before) : at;
}

MissionPlanning::Waiting* MissionPlanning::next_due(MissionTime now) {
  Waiting* first = nullptr;
  MissionTime first_due;
  if (finished_) return first;
  for (auto& [rank, waiting] : awake_) {
    const std::optional<MissionTime> at = waiting.armed ? due(waiting) : std::nullopt;
    if (!at || *at > now || (first != nullptr && *at >= first_due)) continue;
    first = &waiting;
    first_due = *at;
  }
  return first;
}

void MissionPlanning::perform(const std::vector<Action>& actions, const std::string& asked_by,
                              MissionTime now, Effects& effects) {
  ScriptActions deed({asked_by, now + script_.command_lifetime, subject(), terrain_}, effects);
  for (const Action& action : actions) {
    if (finished_) return;
    deed.perform(action);
    finished_ = deed.finished();
  }
}

std::vector<std::string> MissionPlanning::answers() const {
  std::vector<std::string> answers;
  for (const auto& [rank, waiting] : awake_) {
    for (const Leaf& leaf : waiting.leaves) {
      const auto* on = as<OnOperator>(*leaf.trigger);
      const bool waits = waiting.armed && on != nullptr && !leaf.at;
      const bool is_new =
          waits && std::find(answers.begin(), answers.end(), on->does) == answers.end();
      if (is_new) answers.push_back(on->does);
    }
  }
  return answers;
}

void MissionPlanning::fire(Waiting& waiting, MissionTime now, Effects& effects) {
  const Step* step = waiting.step;
  for (Leaf& leaf : waiting.leaves) {
    if (leaf.alarm != AlarmId()) subject_ = leaf.alarm;
    // What has passed stays so, but is not by itself a reason to do the step again.
    const bool lasts = as<AtTime>(*leaf.trigger) != nullptr ||
                       (as<OnSilence>(*leaf.trigger) != nullptr && instant_of(leaf));
    leaf = {leaf.trigger, lasts ? leaf.at : std::nullopt, AlarmId(), lasts && leaf.at};
  }
  waiting.armed = step != nullptr && !step->once;
  waiting.not_before = now + kRest;
  if (step == nullptr) {
    note_operator(waiting.operator_action->does, now, effects);
  } else if (!step->phase.empty() && step->phase != phase_) {
    phase_ = step->phase;
    effects.emplace_back(PhaseEntered{phase_});
  }
  const std::string asked_by =
      step != nullptr ? asked_by_step(step->name) : "operator " + waiting.operator_action->does;
  perform(step != nullptr ? step->actions : waiting.operator_action->actions, asked_by, now,
          effects);
  if (step == nullptr) return;
  effects.emplace_back(StepDone{step->name});
  if (finished_) return;
  mark<OnStep>(now, [&](const OnStep& on) { return on.step == step->name; });
}

const Alarm* MissionPlanning::subject() const {
  const auto found = alarms_.find(subject_);
  return found == alarms_.end() ? nullptr : &found->second;
}

}  // namespace skein::ground_station
