// SPDX-License-Identifier: Apache-2.0
// Reads an event log: one table from the names of the kinds to their readers.
#include <algorithm>
#include <array>
#include <string>

#include "field_reader.hpp"
#include "skein/report/journal.hpp"

namespace skein::report {

namespace {

constexpr std::array<std::string_view, 6> kTaskStates{"scheduled", "started", "running",
                                                      "aborting",  "ended",   "aborted"};
constexpr std::array<std::string_view, 2> kDirections{"sent", "received"};
constexpr std::array<std::string_view, 5> kCommandStates{"issued", "delivered", "acknowledged",
                                                         "refused", "expired"};
constexpr std::array<std::string_view, 3> kAlarmStates{"raised", "confirmed", "infirmed"};

template <class Enumeration, std::size_t N>
Enumeration state(FieldReader& f, const char* key, const std::array<std::string_view, N>& names) {
  return static_cast<Enumeration>(f.one_of(key, names));
}

// Braced initialisers evaluate left to right, so the faults come in the order of the schema.
void read_task(FieldReader& f, Journal& j) {
  j.tasks.push_back({{},
                     f.name("uav"),
                     f.id("task"),
                     f.text("type"),
                     state<TaskState>(f, "state", kTaskStates),
                     f.optional_text("reason")});
}
void read_request(FieldReader& f, Journal& j) {
  j.requests.push_back({{},
                        f.name("uav"),
                        f.text("request"),
                        f.optional_text("mode"),
                        f.optional_id("task"),
                        f.boolean("accepted"),
                        f.optional_text("why")});
}
void read_command(FieldReader& f, Journal& j) {
  j.commands.push_back({{},
                        f.name("uav"),
                        f.id("command"),
                        f.text("what"),
                        state<CommandState>(f, "state", kCommandStates),
                        f.optional_text("why")});
}
void read_sync(FieldReader& f, Journal& j) {
  j.syncs.push_back({{},
                     f.name("id"),
                     f.name("from"),
                     f.name("to"),
                     state<Direction>(f, "direction", kDirections)});
}
void read_message(FieldReader& f, Journal& j) {
  j.messages.push_back({{},
                        f.text("slot"),
                        f.name("from"),
                        f.name("to"),
                        f.id("sequence"),
                        state<Direction>(f, "direction", kDirections)});
}
void read_link(FieldReader& f, Journal& j) {
  j.links.push_back({{}, f.name("from"), f.name("to"), f.boolean("up")});
}
void read_reach(FieldReader& f, Journal& j) {
  j.reaches.push_back({{}, f.name("peer"), f.boolean("reachable")});
}
void read_route(FieldReader& f, Journal& j) {
  j.routes.push_back({{}, f.name("peer"), f.optional_text("via")});
}
void read_telemetry(FieldReader& f, Journal& j) {
  j.telemetry.push_back({{},
                         f.name("uav"),
                         f.position("position"),
                         f.position("velocity"),
                         f.number("heading"),
                         f.number("energy"),
                         f.boolean("airborne")});
}
void read_object(FieldReader& f, Journal& j) {
  j.objects.push_back({{},
                       f.name("name"),
                       f.text("type"),
                       f.position("position"),
                       f.number("radius"),
                       f.boolean("active"),
                       f.optional_number("breadth"),
                       f.optional_point("ignition")});
}
void read_perception(FieldReader& f, Journal& j) {
  j.perceptions.push_back({{}, f.name("uav"), f.text("device"), f.count("detections")});
}
void read_alarm(FieldReader& f, Journal& j) {
  j.alarms.push_back({{},
                      f.id("alarm"),
                      state<AlarmState>(f, "state", kAlarmStates),
                      f.position("position"),
                      f.number("belief")});
}
void read_phase(FieldReader& f, Journal& j) { j.phases.push_back({{}, f.text("name")}); }
void read_operator(FieldReader& f, Journal& j) { j.operators.push_back({{}, f.text("does")}); }
void read_degree(FieldReader& f, Journal& j) {
  j.degrees.push_back({{}, f.name("uav"), f.integer("degree")});
}
void read_fault(FieldReader& f, Journal& j) {
  j.faults.push_back({{}, f.text("what"), f.optional_text("target")});
}
void read_process(FieldReader& f, Journal& j) {
  j.processes.push_back({{}, f.name("name"), f.text("state"), f.optional_text("why")});
}
void read_dropped(FieldReader& f, Journal& j) {
  j.dropped.push_back({{},
                       f.text("slot"),
                       f.optional_text("origin"),
                       f.optional_text("field"),
                       f.optional_text("why")});
}
void read_expired(FieldReader& f, Journal& j) {
  j.undelivered.push_back({{}, true, f.text("slot"), f.name("to"), f.id("sequence")});
}
void read_lost(FieldReader& f, Journal& j) {
  j.undelivered.push_back({{}, false, f.text("slot"), f.name("to"), f.id("sequence")});
}
void read_mission(FieldReader& f, Journal& j) { j.missions.push_back({{}, f.text("state")}); }
void read_expectation(FieldReader& f, Journal& j) {
  j.expectations.push_back({{}, f.text("name"), f.boolean("passed"), f.optional_text("seen")});
}

void read_goal(FieldReader& f, Journal& j) {
  j.goals.push_back({{},
                     f.name("uav"),
                     f.id("goal"),
                     f.id("mission"),
                     f.text("statement"),
                     f.text("state"),
                     f.optional_text("why"),
                     f.optional_text("asked_by")});
}
void read_plan(FieldReader& f, Journal& j) {
  j.plans.push_back({{}, f.name("uav"), f.id("revision"), f.count("tasks")});
}
void read_planned(FieldReader& f, Journal& j) {
  j.planned.push_back({{},
                       f.name("uav"),
                       f.id("revision"),
                       f.id("task"),
                       f.text("type"),
                       f.id("goal"),
                       f.number("earliest_start", kLatestSecond),
                       f.optional_number("latest_start", kLatestSecond),
                       f.number("earliest_end", kLatestSecond),
                       f.optional_number("latest_end", kLatestSecond),
                       f.optional_text("after"),
                       f.optional_text("stop"),
                       f.optional_text("methods"),
                       f.boolean("committed"),
                       f.optional_positions("way")});
}
void read_decision(FieldReader& f, Journal& j) {
  j.decisions.push_back({{},
                         f.name("uav"),
                         f.id("number"),
                         f.text("operator"),
                         f.optional_text("cause"),
                         f.optional_text("inputs"),
                         f.optional_text("outcome"),
                         f.number("took", kLatestSecond)});
}

// Gives the record just read its stamp, or takes it back when its line was wrong.
template <class Record>
void settle(std::vector<Record>& records, Stamp stamp, bool good) {
  if (good) {
    records.back().stamp = std::move(stamp);
  } else {
    records.pop_back();
  }
}

template <auto Member>
void settle_in(Journal& j, Stamp stamp, bool good) {
  settle(j.*Member, std::move(stamp), good);
}

struct Kind {
  std::string_view name;
  void (*read)(FieldReader&, Journal&);
  void (*settle)(Journal&, Stamp, bool good);
};

constexpr std::array<Kind, 26> kKinds{{
    {"telemetry", read_telemetry, settle_in<&Journal::telemetry>},
    {"task", read_task, settle_in<&Journal::tasks>},
    {"message", read_message, settle_in<&Journal::messages>},
    {"request", read_request, settle_in<&Journal::requests>},
    {"command", read_command, settle_in<&Journal::commands>},
    {"sync", read_sync, settle_in<&Journal::syncs>},
    {"link", read_link, settle_in<&Journal::links>},
    {"reach", read_reach, settle_in<&Journal::reaches>},
    {"route", read_route, settle_in<&Journal::routes>},
    {"object", read_object, settle_in<&Journal::objects>},
    {"perception", read_perception, settle_in<&Journal::perceptions>},
    {"alarm", read_alarm, settle_in<&Journal::alarms>},
    {"phase", read_phase, settle_in<&Journal::phases>},
    {"operator", read_operator, settle_in<&Journal::operators>},
    {"degree", read_degree, settle_in<&Journal::degrees>},
    {"fault", read_fault, settle_in<&Journal::faults>},
    {"process", read_process, settle_in<&Journal::processes>},
    {"dropped", read_dropped, settle_in<&Journal::dropped>},
    {"expired", read_expired, settle_in<&Journal::undelivered>},
    {"lost", read_lost, settle_in<&Journal::undelivered>},
    {"mission", read_mission, settle_in<&Journal::missions>},
    {"goal", read_goal, settle_in<&Journal::goals>},
    {"plan", read_plan, settle_in<&Journal::plans>},
    {"planned", read_planned, settle_in<&Journal::planned>},
    {"decision", read_decision, settle_in<&Journal::decisions>},
    {"expectation", read_expectation, settle_in<&Journal::expectations>},
}};

void read_object_line(const nlohmann::json& object, const Diagnostic& where,
                      SalvagedJournal& result) {
  const std::size_t faults_before = result.errors.size();
  FieldReader fields(object, where, result.errors);
  Stamp stamp;
  stamp.at = MissionTime::seconds(fields.number("at", kLatestSecond));
  stamp.node = fields.name("node");
  stamp.line = static_cast<std::size_t>(where.line);
  const std::string name = fields.text("kind");
  const auto kind =
      std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind& k) { return k.name == name; });
  if (kind != kKinds.end()) kind->read(fields, result.journal);
  const bool good = result.errors.size() == faults_before;
  if (good) stamp.extra = fields.rest();
  if (kind != kKinds.end()) {
    kind->settle(result.journal, std::move(stamp), good);
  } else if (good) {
    result.journal.others.push_back({std::move(stamp), name});
  }
}

template <class Record>
void sort_records(std::vector<Record>& records) {
  const auto earlier = [](const Record& a, const Record& b) { return a.stamp.at < b.stamp.at; };
  if (!std::is_sorted(records.begin(), records.end(), earlier)) {
    std::stable_sort(records.begin(), records.end(), earlier);
  }
}

template <class... Vectors>
void sort_each(Vectors&... vectors) {
  (sort_records(vectors), ...);
}

}  // namespace

SalvagedJournal salvage_journal(std::istream& in, std::string_view name) {
  SalvagedJournal result;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) continue;
    const std::size_t faults_before = result.errors.size();
    Diagnostic where{std::string(name), number, 0, "", "", "", ""};
    const std::optional<nlohmann::json> value = parse_json(line, where, result.errors);
    if (value && value->is_object()) {
      read_object_line(*value, where, result);
    } else if (value) {
      where.message = "not a JSON object";
      result.errors.add(std::move(where));
    }
    if (result.errors.size() > faults_before) ++result.journal.unreadable;
  }
  sort_by_time(result.journal);
  return result;
}

Result<Journal, Diagnostics> read_journal(std::istream& in, std::string_view name) {
  SalvagedJournal read = salvage_journal(in, name);
  if (!read.errors.empty()) return tl::unexpected<Diagnostics>(std::move(read.errors));
  return std::move(read.journal);
}

void sort_by_time(Journal& j) {
  sort_each(j.tasks, j.requests, j.commands, j.syncs, j.messages, j.links, j.reaches, j.routes,
            j.telemetry, j.objects, j.perceptions, j.alarms, j.phases, j.operators, j.degrees,
            j.faults, j.processes, j.dropped, j.undelivered, j.missions, j.expectations, j.goals,
            j.plans, j.planned, j.decisions, j.others);
}

}  // namespace skein::report
