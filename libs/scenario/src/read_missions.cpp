// SPDX-License-Identifier: Apache-2.0
#include "read_missions.hpp"

#include <algorithm>
#include <numbers>

namespace skein::scenario {

namespace {

using config::Reader;
using ground_station::Action;
using ground_station::ArgumentTarget;
using mission::GoalId;
using mission::MissionId;

template <class AnId>
AnId read_id(const Reader& reader) {
  const std::uint64_t id = reader.natural();
  if (reader.present() && id == 0) reader.error("0 is no id", "a whole number from 1");
  return AnId(id);
}

world::Mark mark_of(const Reader& reader) { return {reader.line(), reader.path()}; }

// A word, or the number that is written there.
mission::Argument read_word(const Reader& reader) {
  if (const auto number = number_in(reader)) return *number;
  return reader.text();
}

mission::Argument read_list(const Reader& reader) {
  const std::vector<Reader> items = items_of(reader);
  const auto numeric = [](const Reader& one) { return number_in(one).has_value(); };
  if (!items.empty() && std::all_of(items.begin(), items.end(), numeric)) return read_point(reader);
  std::vector<std::string> names;
  for (const Reader& item : items) {
    if (numeric(item)) item.error("a number among names", "names, or [x, y, z]");
    names.push_back(item.text());
  }
  return names;
}

std::optional<std::variant<ground_station::TheAlarm, ground_station::NearAlarm>> read_about_alarm(
    const Reader& reader) {
  if (reader.is_scalar() && reader.text() == "alarm") return ground_station::TheAlarm{};
  if (!reader.is_map()) return std::nullopt;
  reader.keys({"near_alarm"});
  return read_near_alarm(reader.required("near_alarm"));
}

std::optional<MissionTime> read_bound(const Reader& reader) {
  return reader.present() ? std::optional(read_instant(reader)) : std::nullopt;
}

constexpr double kLongest = 1e6;  // [s]

// {goal: ID, least: s, most: s}
void read_after(const Reader& reader, bool on_end, const std::string& uav,
                mission::HighLevelTask& task, TaskContext& context) {
  if (!reader.present()) return;
  reader.keys({"goal", "least", "most"});
  mission::GoalBound bound;
  bound.goal = read_goal_id(reader.required("goal"), uav, context);
  bound.on_end = on_end;
  const Reader least = reader.optional("least"), most = reader.optional("most");
  if (least.present()) bound.least = Duration::seconds(least.number(0, {0, kLongest}));
  if (most.present()) bound.most = Duration::seconds(most.number(0, {0, kLongest}));
  if (!least.present() && !most.present()) {
    reader.error("no bound", "least: seconds, most: seconds, or both");
  }
  if (bound.least > bound.most) most.error("less than least", "a number from least on");
  if (bound.goal == task.id) reader.error("a goal after itself", "another goal");
  task.after.push_back(bound);
}

mission::HighLevelTask read_goal(const Reader& reader, const std::string& uav, std::size_t number,
                                 std::vector<ArgumentTarget>& targets, TaskContext& context) {
  mission::HighLevelTask task;
  if (!reader.keys({"id", "task", "start_before", "start_after", "end_before", "end_after",
                    "start_after_goal", "end_after_goal"})) {
    return task;
  }
  const Reader id = reader.required("id");
  task.id = read_id<GoalId>(id);
  if (!uav.empty() && id.present() &&
      !context.goals.emplace(std::pair(uav, task.id), mark_of(reader)).second) {
    id.error("high-level task " + to_text(task.id) + " is asked of " + uav + " twice",
             "ids that are unique for the whole mission");
  }
  if (id.present() && context.team_tasks.contains(task.id) && is_of_team(uav, context)) {
    id.error("high-level task " + to_text(task.id) + " is a task of the team, which " + uav +
                 " may be sold",
             "an id that no task of the team has");
  }
  read_statement(reader.required("task"), task, number, targets);
  task.time = read_time_constraints(reader);
  read_after(reader.optional("start_after_goal"), false, uav, task, context);
  read_after(reader.optional("end_after_goal"), true, uav, task, context);
  return task;
}

std::string read_uav(const Reader& reader, const TaskContext& context) {
  return reader.required("uav").name_among(context.names.uavs, "a UAV");
}

Action read_mission(const Reader& reader, TaskContext& context) {
  reader.keys({"uav", "id", "tasks", "placement", "interrupt", "achieve", "evaluate"});
  if (!context.scenario.planning) reader.error(kNoPlanning, kPlanningWanted);
  ground_station::SendMission send;
  send.uav = read_uav(reader, context);
  const Reader id = reader.required("id"), interrupt = reader.optional("interrupt");
  send.mission.id = read_id<MissionId>(id);
  if (!send.uav.empty() && id.present() &&
      !context.missions.emplace(send.uav, send.mission.id).second) {
    id.error("mission " + to_text(send.mission.id) + " is sent to " + send.uav + " twice",
             "ids that are unique for the whole mission");
  }
  for (const Reader& task : items_of(reader.required("tasks"))) {
    send.mission.tasks.push_back(
        read_goal(task, send.uav, send.mission.tasks.size(), send.targets, context));
  }
  send.mission.placement = static_cast<mission::Placement>(
      reader.optional("placement").choice({"best", "last", "in-time", "tour", "first"}));
  send.mission.any = reader.optional("achieve").choice({"all", "any"}) == 1;
  send.mission.interrupt = interrupt.boolean(false);
  send.mission.evaluate = reader.optional("evaluate").boolean(false);
  if (send.mission.interrupt && send.mission.placement != mission::Placement::kFirst) {
    interrupt.error("only what comes first interrupts what is under way", "placement: first");
  }
  return send;
}

// It has the number of a task.
Action read_play(const Reader& reader, TaskContext& context) {
  reader.keys({"uav", "id", "task", "start_before", "start_after"});
  if (!context.scenario.planning) reader.error(kNoPlanning, kPlanningWanted);
  if (context.scenario.interaction == nullptr) {
    reader.error("the scenario has no interaction models", "interaction: FILE");
  }
  ground_station::PlayRole play{read_uav(reader, context), {}};
  const Reader id = reader.required("id");
  const executive::TaskId task = read_task_id(id);
  play.task.id = GoalId(task.value());
  context.played.emplace(std::pair(play.uav, play.task.id), mark_of(reader));
  if (!play.uav.empty() && id.present() && !context.planned.emplace(play.uav, task).second) {
    id.error("task " + to_text(task) + " of " + play.uav + " is planned twice",
             "ids that are unique for the whole mission");
  }
  std::vector<ArgumentTarget> targets;
  read_statement(reader.required("task"), play.task, 0, targets);
  if (!targets.empty()) reader.required("task").error("an alarm's place", "places by name");
  play.task.time.start_before = read_bound(reader.optional("start_before"));
  play.task.time.start_after = read_bound(reader.optional("start_after"));
  return play;
}

Action read_cancel(const Reader& reader, TaskContext& context) {
  reader.keys({"uav", "goals", "mission", "interrupt"});
  at_most_one_of(reader, {"goals", "mission"});
  ground_station::CancelMission cancel;
  cancel.uav = read_uav(reader, context);
  const Reader goals = reader.optional("goals"), of = reader.optional("mission");
  if (!goals.present() && !of.present()) {
    reader.error("nothing to cancel", "goals: [ID...], goals: all or mission: ID");
  } else if (of.present()) {
    cancel.cancel.mission = read_mission_id(of, cancel.uav, context);
  } else if (goals.is_scalar()) {
    (void)goals.choice({"all"});
  } else {
    for (const Reader& id : items_of(goals)) {
      cancel.cancel.goals.push_back(read_goal_id(id, cancel.uav, context));
    }
    if (cancel.cancel.goals.empty()) goals.error("nothing to cancel", "[ID...] or all");
  }
  cancel.cancel.interrupt = reader.optional("interrupt").boolean(true);
  return cancel;
}

Action read_degree(const Reader& reader, TaskContext& context) {
  reader.keys({"uav", "to", "interrupt", "resume"});
  ground_station::SetDegree set{read_uav(reader, context), {}};
  set.change.degree = read_degree_number(reader.required("to"));
  if (mission::deliberates(set.change.degree) && !context.scenario.planning) {
    reader.optional("to").error(kNoPlanning, kPlanningWanted);
  } else if (mission::allocates(set.change.degree) && !set.uav.empty() &&
             !in_team(context.scenario, set.uav)) {
    reader.optional("to").error(kNoTeam, kTeamWanted);
  }
  set.change.interrupt = reader.optional("interrupt").boolean(false);
  set.change.resume = reader.optional("resume").boolean(true);
  return set;
}

Action read_take_in_hand(const Reader& reader, TaskContext& context) {
  reader.keys({"uav", "interrupt"});
  return ground_station::TakeInHand{read_uav(reader, context),
                                    reader.optional("interrupt").boolean(false)};
}

Action read_give_back(const Reader& reader, TaskContext& context) {
  reader.keys({"uav"});
  return ground_station::GiveBack{read_uav(reader, context)};
}

Action read_resume_plan(const Reader& reader, TaskContext& context) {
  reader.keys({"uav", "without"});
  ground_station::ResumePlan resume{read_uav(reader, context)};
  for (const Reader& id : items_of(reader.optional("without"))) {
    resume.without.push_back(read_task_id(id));
  }
  return resume;
}

Action read_drop_plan(const Reader& reader, TaskContext& context) {
  reader.keys({"uav"});
  return ground_station::DropPlan{read_uav(reader, context)};
}

std::vector<std::string> read_uavs_of(const Reader& reader, const TaskContext& context) {
  std::vector<std::string> uavs;
  for (const Reader& uav : items_of(reader)) {
    uavs.push_back(uav.name_among(context.names.uavs, "a UAV"));
  }
  return uavs;
}

Action read_close_air(const Reader& reader, TaskContext& context) {
  reader.keys({"name", "polygon", "floor", "ceiling", "from", "until", "uavs"});
  return ground_station::CloseAir{world::read_volume(reader.required("name").text(), reader),
                                  read_uavs_of(reader.optional("uavs"), context)};
}

Action read_open_air(const Reader& reader, TaskContext& context) {
  reader.keys({"name", "uavs"});
  const Reader name = reader.required("name");
  const auto& volumes = context.names.volumes;
  return ground_station::OpenAir{
      context.live ? name.text() : name.name_among(volumes, "a volume of closed air"),
      read_uavs_of(reader.optional("uavs"), context)};
}

std::optional<world::CellState> read_cells(const Reader& reader) {
  if (!reader.present()) return std::nullopt;
  return static_cast<world::CellState>(reader.choice({"quiet", "alarm", "fire"}));
}

Action read_know_place(const Reader& reader, TaskContext& context) {
  reader.keys({"name", "at", "radius", "cells", "uavs"});
  ground_station::TellWorld tell;
  const Reader radius = reader.optional("radius");
  tell.change.place = {reader.required("name").text(), world::read_point(reader.required("at")),
                       radius.present() ? radius.number() : 0,
                       read_cells(reader.optional("cells"))};
  for (const std::string& why : mission::problems_of(tell.change)) reader.error(why, "a place");
  tell.uavs = read_uavs_of(reader.optional("uavs"), context);
  return tell;
}

Action read_know_ground(const Reader& reader, TaskContext& context) {
  reader.keys({"name", "polygon", "risk", "mapped", "cells", "uavs"});
  ground_station::TellWorld tell;
  mission::KnownGround ground;
  ground.name = reader.required("name").text();
  ground.area = world::read_polygon(reader.required("polygon"));
  if (const Reader risk = reader.optional("risk"); risk.present()) ground.risk = risk.number();
  ground.mapped = reader.optional("mapped").boolean(false);
  ground.cells = read_cells(reader.optional("cells"));
  tell.change.ground = std::move(ground);
  for (const std::string& why : mission::problems_of(tell.change)) reader.error(why, "risk, …");
  tell.uavs = read_uavs_of(reader.optional("uavs"), context);
  return tell;
}

template <class AnId>
AnId referred(const Reader& reader, const std::string& uav, bool is_goal, TaskContext& context) {
  const auto id = read_id<AnId>(reader);
  if (!uav.empty() && reader.present()) {
    context.references.push_back({reader, uav, id.value(), is_goal});
  }
  return id;
}

}  // namespace

// The name of the task and its arguments; those about the alarm are known when the mission is sent.
void read_statement(const Reader& reader, mission::HighLevelTask& task, std::size_t number,
                    std::vector<ArgumentTarget>& targets) {
  const std::vector<Reader> items = items_of(reader);
  if (reader.is_sequence() && items.empty()) reader.error("no task", "[NAME, ARGUMENT...]");
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i == 0) {
      task.name = items[i].text();
    } else if (const auto where = read_about_alarm(items[i])) {
      targets.push_back({number, i - 1, *where});
      task.arguments.emplace_back(world::Vector3(world::Vector3::Zero()));
    } else {
      task.arguments.push_back(items[i].is_sequence() ? read_list(items[i]) : read_word(items[i]));
    }
  }
}

mission::TimeConstraints read_time_constraints(const Reader& reader) {
  return {read_bound(reader.optional("start_before")), read_bound(reader.optional("start_after")),
          read_bound(reader.optional("end_before")), read_bound(reader.optional("end_after"))};
}

MissionId read_mission_id(const Reader& reader, const std::string& uav, TaskContext& context) {
  return referred<MissionId>(reader, uav, false, context);
}

GoalId read_goal_id(const Reader& reader, const std::string& uav, TaskContext& context) {
  return referred<GoalId>(reader, uav, true, context);
}

int read_degree_number(const Reader& reader) {
  return static_cast<int>(reader.integer(3, mission::kLeastDegree, mission::kGreatestDegree));
}

void check_references(const TaskContext& context) {
  for (const Reference& one : context.references) {
    if (one.uav.empty()) {
      const bool given = one.is_goal ? context.team_tasks.contains(GoalId(one.id))
                                     : context.global_missions.contains(MissionId(one.id));
      if (given) continue;
      one.at.error(std::string(one.is_goal ? "task " : "global mission ") + std::to_string(one.id) +
                       " is never given to the team",
                   "one that the script gives");
      continue;
    }
    const bool known = one.is_goal ? context.goals.contains({one.uav, GoalId(one.id)})
                                   : context.missions.contains({one.uav, MissionId(one.id)});
    if (known) continue;
    one.at.error(std::string(one.is_goal ? "high-level task " : "mission ") +
                     std::to_string(one.id) + " is never sent to " + one.uav,
                 "one that the script sends");
  }
}

const std::vector<MissionAction>& mission_actions() {
  static const std::vector<MissionAction> kActions{{"mission", read_mission},
                                                   {"cancel", read_cancel},
                                                   {"play", read_play},
                                                   {"degree", read_degree},
                                                   {"take_in_hand", read_take_in_hand},
                                                   {"give_back", read_give_back},
                                                   {"resume_plan", read_resume_plan},
                                                   {"drop_plan", read_drop_plan},
                                                   {"close_air", read_close_air},
                                                   {"open_air", read_open_air},
                                                   {"know_place", read_know_place},
                                                   {"know_ground", read_know_ground},
                                                   {"global_mission", read_global_mission},
                                                   {"declare_lost", read_declare_lost},
                                                   {"declare_found", read_declare_found}};
  return kActions;
}

}  // namespace skein::scenario
