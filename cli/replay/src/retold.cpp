// SPDX-License-Identifier: Apache-2.0
#include "retold.hpp"

#include <algorithm>
#include <cmath>

#include "skein/blackboard/link_instance.hpp"

namespace skein::replay_tool {

namespace {

using journal::Record;
using wire::Sample;
using Samples = std::vector<Sample>;

constexpr std::uint32_t kGround = 1;
constexpr std::uint32_t kFirstUav = 10;
constexpr std::size_t kDecisions = 20, kCommands = 30;  ///< that are shown

std::uint64_t id_of(const Record& record, std::string_view key) {
  const double number = record.number(key);
  return number >= 0 && number < 9e15 ? static_cast<std::uint64_t>(number) : 0;
}

std::string text_of(const Record& record, std::string_view key) {
  return std::string(record.text(key));
}

wire::Vector3 point_of(const Record& record, std::string_view key) {
  const std::vector<double> numbers = record.numbers(key);
  return numbers.size() == 3 ? wire::Vector3{numbers[0], numbers[1], numbers[2]} : wire::Vector3{};
}

wire::FloatVector3 rounded(const wire::Vector3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// A name of the log that the wire does not have stays what it was.
template <wire::WireEnum E>
void set_by_name(E& value, std::string_view name) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(E::kCount); ++i)
    if (name_of(static_cast<E>(i)) == name) value = static_cast<E>(i);
}

std::int64_t instant(const Record& record, std::string_view key, std::int64_t otherwise) {
  const double seconds = record.number(key, NAN);
  return std::abs(seconds) < 1e8 ? MissionTime::seconds(seconds).count() : otherwise;
}

std::vector<std::string> parted(const std::string& text, std::string_view separator) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    parts.push_back(text.substr(at, end - at));
    at = end + separator.size();
  }
  return parts;
}

/// The one of that id, or a new one.
template <class Entry>
Entry& entry_of(std::vector<Entry>& all, std::uint64_t id) {
  const auto found =
      std::find_if(all.begin(), all.end(), [id](const Entry& one) { return one.id == id; });
  if (found != all.end()) return *found;
  Entry& entry = all.emplace_back();
  entry.id = id;
  return entry;
}

}  // namespace

Retold::Retold(const std::vector<std::string>& uavs) {
  std::uint32_t number = kFirstUav;
  ground_.header.origin = kGround;
  ground_.uavs = uavs;
  for (const std::string& name : uavs) {
    Uav& uav = uavs_[name];
    uav.board.header.origin = uav.tasks.header.origin = kGround;
    uav.board.header.instance = uav.tasks.header.instance = number++;
    uav.board.uav = uav.tasks.uav = name;
    uav.board.reachable = true;
  }
}

const std::map<std::string, Retold::Teller, std::less<>>& Retold::tellers() {
  static const std::map<std::string, Teller, std::less<>> all = {
      {"telemetry", &Retold::take_telemetry}, {"degree", &Retold::take_degree},
      {"hand", &Retold::take_hand},           {"task", &Retold::take_task},
      {"goal", &Retold::take_goal},           {"plan", &Retold::take_plan},
      {"planned", &Retold::take_planned},     {"decision", &Retold::take_decision},
      {"joint", &Retold::take_joint}};
  return all;
}

Samples Retold::see(const Record& record) {
  Samples news;
  if (take_for_all(record, news)) return news;
  const auto teller = tellers().find(record.kind());
  const auto uav = uavs_.find(record.text("uav"));
  if (teller == tellers().end() || uav == uavs_.end()) return news;
  return (this->*teller->second)(record, uav->second);
}

bool Retold::take_for_all(const Record& record, Samples& news) {
  const std::string& kind = record.kind();
  if (kind == "link") {
    news.push_back(link(record));
  } else if (kind == "seen") {
    news.push_back(seen(record));
  } else if (kind == "reach") {
    news = take_reach(record);
  } else if (kind == "phase" || kind == "alarm" || kind == "command" || kind == "owner" ||
             kind == "mission") {
    if (kind == "phase") ground_.phase = text_of(record, "name");
    if (kind == "alarm") take_alarm(record);
    if (kind == "command") take_command(record);
    if (kind == "owner") take_owner(record);
    if (kind == "mission") ground_.finished = record.text("state") != "started";
    news.emplace_back(ground_);
  } else {
    return false;
  }
  return true;
}

// As nodes number them: each joint task of a UAV is an instance of its own.
Samples Retold::take_joint(const Record& record, Uav& uav) {
  const std::string subject = text_of(record, "joint");
  const auto [found, is_new] = uav.joint.try_emplace(subject);
  wire::JointTaskState& state = found->second;
  state.header.origin = uav.board.header.instance;
  if (is_new) state.header.instance = static_cast<std::uint32_t>(uav.joint.size());
  state.uav = uav.board.uav;
  state.subject = subject;
  state.task = id_of(record, "task");
  state.model = text_of(record, "model");
  state.variant = text_of(record, "variant");
  set_by_name(state.phase, record.text("phase"));
  state.why = text_of(record, "why");
  state.agreed_start = instant(record, "start", wire::kNoInstant);
  state.active_blocks = parted(text_of(record, "blocks"), " ");
  state.violated = parted(text_of(record, "violated"), " ");
  state.holders.clear();
  for (const std::string& one : parted(text_of(record, "holders"), ", ")) {
    const std::size_t space = one.find(' ');
    if (space != one.npos) state.holders.push_back({one.substr(0, space), one.substr(space + 1)});
  }
  return {state};
}

void Retold::take_owner(const Record& record) {
  wire::BoardTeamTask& task = entry_of(ground_.team, id_of(record, "task"));
  task.statement = text_of(record, "statement");
  task.stage = text_of(record, "stage");
  task.why = text_of(record, "why");
  task.owners = parted(text_of(record, "owners"), ", ");
}

Samples Retold::take_telemetry(const Record& record, Uav& uav) {
  wire::Telemetry telemetry;
  telemetry.header.origin = uav.board.header.instance;
  telemetry.header.mission_time = record.at().count();
  telemetry.uav = uav.board.uav;
  uav.board.position = point_of(record, "position");
  uav.board.velocity = point_of(record, "velocity");
  uav.board.heading = record.number("heading");
  uav.board.energy = record.number("energy");
  telemetry.position = rounded(uav.board.position);
  telemetry.velocity = rounded(uav.board.velocity);
  telemetry.heading = static_cast<float>(uav.board.heading);
  telemetry.energy = static_cast<float>(uav.board.energy);
  telemetry.airborne = uav.board.airborne = record.truth("airborne");
  uav.board.located_at = record.at().count();
  return {telemetry, uav.board};
}

Samples Retold::take_degree(const Record& record, Uav& uav) {
  uav.board.degree = static_cast<std::uint8_t>(std::min<std::uint64_t>(id_of(record, "degree"), 9));
  return {uav.board};
}

Samples Retold::take_hand(const Record& record, Uav& uav) {
  uav.board.holder = text_of(record, "holder");
  uav.board.asker = text_of(record, "asker");
  return {uav.board};
}

Samples Retold::take_task(const Record& record, Uav& uav) {
  wire::BoardTask& task = entry_of(uav.tasks.tasks, id_of(record, "task"));
  task.type = text_of(record, "type");
  set_by_name(task.state, record.text("state"));
  task.reason = text_of(record, "reason");
  task.since = record.at().count();
  task.at_ground = record.node() == "ground";
  return {uav.tasks};
}

Samples Retold::take_goal(const Record& record, Uav& uav) {
  wire::GoalEntry& goal = entry_of(uav.tasks.goals, id_of(record, "goal"));
  goal.mission = id_of(record, "mission");
  goal.statement = text_of(record, "statement");
  set_by_name(goal.state, record.text("state"));
  goal.why = text_of(record, "why");
  goal.asked_by = text_of(record, "asked_by");
  goal.done = text_of(record, "done");
  return {uav.tasks};
}

Samples Retold::take_plan(const Record& record, Uav& uav) {
  uav.tasks.revision = id_of(record, "revision");
  return {uav.tasks};
}

// A revision tells what is new or changed in it: the others stay, but for those that are over.
Samples Retold::take_planned(const Record& record, Uav& uav) {
  wire::PlanEntry entry;
  entry.id = id_of(record, "task");
  entry.type = text_of(record, "type");
  entry.origin = id_of(record, "goal");
  entry.earliest_start = instant(record, "earliest_start", 0);
  entry.latest_start = instant(record, "latest_start", wire::kNever);
  entry.earliest_end = instant(record, "earliest_end", 0);
  entry.latest_end = instant(record, "latest_end", wire::kNever);
  entry.committed = record.truth("committed");
  entry.way = record.numbers("way");
  entry.methods = text_of(record, "methods");
  uav.plan[entry.id] = std::move(entry);
  for (const wire::BoardTask& task : uav.tasks.tasks)
    if (task.state == wire::TaskState::kEnded || task.state == wire::TaskState::kAborted)
      uav.plan.erase(task.id);
  uav.tasks.plan.clear();
  for (const auto& [id, planned] : uav.plan) uav.tasks.plan.push_back(planned);
  return {uav.tasks};
}

Samples Retold::take_decision(const Record& record, Uav& uav) {
  auto& decisions = uav.tasks.decisions;
  decisions.push_back({id_of(record, "number"), text_of(record, "operator"),
                       text_of(record, "cause"), text_of(record, "outcome"), record.at().count()});
  if (decisions.size() > kDecisions) decisions.erase(decisions.begin());
  return {uav.tasks};
}

Samples Retold::take_reach(const Record& record) {
  const auto uav = uavs_.find(record.text("peer"));
  if (record.node() != "ground" || uav == uavs_.end()) return {};
  uav->second.board.reachable = record.truth("reachable");
  return {uav->second.board};
}

void Retold::take_alarm(const Record& record) {
  const auto id = static_cast<std::uint32_t>(id_of(record, "alarm"));
  const auto found = std::find_if(ground_.alarms.begin(), ground_.alarms.end(),
                                  [id](const wire::BoardAlarm& one) { return one.id == id; });
  const bool fresh = found == ground_.alarms.end();
  wire::BoardAlarm& alarm = fresh ? ground_.alarms.emplace_back() : *found;
  if (fresh) alarm.first_seen = record.at().count();
  alarm.id = id;
  set_by_name(alarm.state, record.text("state"));
  alarm.position = point_of(record, "position");
  alarm.belief = record.number("belief");
  alarm.last_seen = record.at().count();
}

void Retold::take_command(const Record& record) {
  const std::uint64_t number = id_of(record, "command");
  auto& all = ground_.commands;
  auto found = std::find_if(all.begin(), all.end(), [&](const wire::CommandEntry& one) {
    return one.command == number && one.uav == record.text("uav");
  });
  if (found == all.end()) {
    if (all.size() == kCommands) all.erase(all.begin());
    found = all.insert(all.end(), wire::CommandEntry{});
    found->command = number;
    found->uav = text_of(record, "uav");
    found->issued = record.at().count();
  }
  found->what = text_of(record, "what");
  found->why = text_of(record, "why");
  set_by_name(found->state, record.text("state"));
  if (wire::is_settled(found->state)) found->settled = record.at().count();
}

Sample Retold::seen(const Record& record) {
  wire::SeenObject object;
  object.name = text_of(record, "name");
  object.header.origin = kGround;
  const auto number = static_cast<std::uint32_t>(objects_.size());
  object.header.instance = objects_.try_emplace(object.name, number).first->second;
  object.kind = text_of(record, "type");
  object.at = point_of(record, "position");
  object.spread = record.number("spread");
  object.seen = instant(record, "when", record.at().count());
  return object;
}

Sample Retold::link(const Record& record) const {
  wire::LinkState state;
  const auto end_of = [&](std::string_view node) {
    return node == "*" ? blackboard::kEverybody.value() : number_of(node);
  };
  state.from = end_of(record.text("from"));
  state.to = end_of(record.text("to"));
  state.up = record.truth("up");
  state.header.origin = 2;
  state.header.instance = blackboard::link_instance(blackboard::NodeNumber(state.from),
                                                    blackboard::NodeNumber(state.to));
  return state;
}

std::uint32_t Retold::number_of(std::string_view node) const {
  const auto uav = uavs_.find(node);
  return uav == uavs_.end() ? kGround : uav->second.board.header.instance;
}

}  // namespace skein::replay_tool
