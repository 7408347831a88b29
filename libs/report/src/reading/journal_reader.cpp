// SPDX-License-Identifier: Apache-2.0
// Reads an event log: one table from the names of the kinds to their readers.
#include <algorithm>
#include <array>
#include <numeric>
#include <string>

#include "reading/field_reader.hpp"
#include "skein/journal/lines/execution.hpp"
#include "skein/journal/lines/radio.hpp"
#include "skein/journal/lines/run.hpp"
#include "skein/journal/lines/truth.hpp"
#include "skein/report/journal.hpp"

namespace skein::report {

namespace {

namespace lines = journal::lines;

constexpr std::array<std::string_view, 6> kTaskStates{"scheduled", "started", "running",
                                                      "aborting",  "ended",   "aborted"};
constexpr std::array<std::string_view, 2> kDirections{"sent", "received"};
constexpr std::array<std::string_view, 5> kCommandStates{"issued", "delivered", "acknowledged",
                                                         "refused", "expired"};
constexpr std::array<std::string_view, 3> kAlarmStates{"raised", "confirmed", "infirmed"};

template <class Enumeration, std::size_t N>
Enumeration state(FieldReader& f, const char* key, const std::string& text,
                  const std::array<std::string_view, N>& names) {
  return static_cast<Enumeration>(f.one_of(key, text, names));
}

// What lines of each kind are to the report.
TaskRecord to_record(lines::Task&& l, FieldReader& f) {
  return {{},
          std::move(l.uav),
          l.task,
          std::move(l.type),
          state<TaskState>(f, "state", l.state, kTaskStates),
          std::move(l.reason)};
}
RequestRecord to_record(lines::Request&& l, FieldReader&) {
  return {{},     std::move(l.uav), std::move(l.request), std::move(l.mode),
          l.task, l.accepted,       std::move(l.why)};
}
CommandRecord to_record(lines::Command&& l, FieldReader& f) {
  return {{},
          std::move(l.uav),
          l.command,
          std::move(l.what),
          state<CommandState>(f, "state", l.state, kCommandStates),
          std::move(l.why)};
}
SyncRecord to_record(lines::Sync&& l, FieldReader& f) {
  return {{},
          std::to_string(l.id),
          std::move(l.from),
          std::move(l.to),
          state<Direction>(f, "direction", l.direction, kDirections)};
}
MessageRecord to_record(lines::Message&& l, FieldReader& f) {
  std::optional<SessionName> session;
  if (l.opened) session = SessionName{std::move(l.subject), std::move(l.opener), *l.opened};
  return {{},
          std::move(l.slot),
          std::move(l.from),
          std::move(l.to),
          l.sequence,
          state<Direction>(f, "direction", l.direction, kDirections),
          std::move(session)};
}
LinkRecord to_record(lines::Link&& l, FieldReader&) {
  return {{}, std::move(l.from), std::move(l.to), l.up};
}
ReachRecord to_record(lines::Reach&& l, FieldReader&) {
  return {{}, std::move(l.peer), l.reachable};
}
RouteRecord to_record(lines::Route&& l, FieldReader&) {
  return {{}, std::move(l.peer), std::move(l.via)};
}
TelemetryRecord to_record(lines::Telemetry&& l, FieldReader& f) {
  return {{},
          std::move(l.uav),
          f.position("position", l.position),
          f.position("velocity", l.velocity),
          l.heading,
          l.energy,
          l.airborne};
}
ObjectRecord to_record(lines::Object&& l, FieldReader& f) {
  return {{},       std::move(l.name), std::move(l.type), f.position("position", l.position),
          l.radius, l.active,          l.breadth,         f.point("ignition", l.ignition)};
}
PerceptionRecord to_record(lines::Perception&& l, FieldReader&) {
  return {{}, std::move(l.uav), std::move(l.device), l.detections};
}
AlarmRecord to_record(lines::Alarm&& l, FieldReader& f) {
  return {{},
          l.alarm,
          state<AlarmState>(f, "state", l.state, kAlarmStates),
          f.position("position", l.position),
          l.belief};
}
PhaseRecord to_record(lines::Phase&& l, FieldReader&) { return {{}, std::move(l.name)}; }
OperatorRecord to_record(lines::Operator&& l, FieldReader&) { return {{}, std::move(l.does)}; }
OperatorRecord to_record(lines::LostUav&& l, FieldReader&) { return {{}, l.uav + " is lost"}; }
OperatorRecord to_record(lines::FoundUav&& l, FieldReader&) { return {{}, l.uav + " is found"}; }
DegreeRecord to_record(lines::Degree&& l, FieldReader&) { return {{}, std::move(l.uav), l.degree}; }
FaultRecord to_record(lines::Fault&& l, FieldReader&) {
  return {{}, std::move(l.what), std::move(l.target)};
}
ProcessRecord to_record(lines::Process&& l, FieldReader&) {
  return {{}, std::move(l.name), std::move(l.state), std::move(l.why)};
}
DroppedRecord to_record(lines::Dropped&& l, FieldReader&) {
  return {{}, std::move(l.slot), std::move(l.origin), std::move(l.field), std::move(l.why)};
}
UndeliveredRecord to_record(lines::Expired&& l, FieldReader&) {
  return {{}, true, std::move(l.slot), std::move(l.to), l.sequence};
}
UndeliveredRecord to_record(lines::Lost&& l, FieldReader&) {
  return {{}, false, std::move(l.slot), std::move(l.to), l.sequence};
}
MissionRecord to_record(lines::Mission&& l, FieldReader&) { return {{}, std::move(l.state)}; }
ExpectationRecord to_record(lines::Expectation&& l, FieldReader&) {
  return {{}, std::move(l.name), l.passed, std::move(l.seen)};
}
GoalRecord to_record(lines::Goal&& l, FieldReader&) {
  return {{},
          std::move(l.uav),
          l.goal,
          l.mission,
          std::move(l.statement),
          std::move(l.state),
          std::move(l.why),
          std::move(l.asked_by)};
}
PlanRecord to_record(lines::Plan&& l, FieldReader&) {
  return {{}, std::move(l.uav), l.revision, l.tasks};
}
PlannedRecord to_record(lines::Planned&& l, FieldReader& f) {
  return {{},
          std::move(l.uav),
          l.revision,
          l.task,
          std::move(l.type),
          l.goal,
          l.earliest_start,
          l.latest_start,
          l.earliest_end,
          l.latest_end,
          std::move(l.after),
          std::move(l.stop),
          std::move(l.methods),
          l.committed,
          f.positions("way", l.way)};
}
DecisionRecord to_record(lines::Decision&& l, FieldReader&) {
  return {{},
          std::move(l.uav),
          l.number,
          std::move(l.operator_),
          std::move(l.cause),
          std::move(l.inputs),
          std::move(l.outcome),
          l.took};
}
template <class Line>
Told<Line> to_record(Line&& line, FieldReader&) {
  return {{}, std::forward<Line>(line)};
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

struct Kind {
  std::string_view name;
  void (*read)(FieldReader&, Journal&);
  void (*settle)(Journal&, Stamp, bool good);
};

template <class Line, auto Member>
constexpr Kind kind() {
  return {Line::kKind,
          [](FieldReader& f, Journal& j) { (j.*Member).push_back(to_record(f.line<Line>(), f)); },
          [](Journal& j, Stamp stamp, bool good) { settle(j.*Member, std::move(stamp), good); }};
}

constexpr std::array kKinds{
    kind<lines::Telemetry, &Journal::telemetry>(),
    kind<lines::Task, &Journal::tasks>(),
    kind<lines::Message, &Journal::messages>(),
    kind<lines::Request, &Journal::requests>(),
    kind<lines::Command, &Journal::commands>(),
    kind<lines::Sync, &Journal::syncs>(),
    kind<lines::Link, &Journal::links>(),
    kind<lines::Reach, &Journal::reaches>(),
    kind<lines::Route, &Journal::routes>(),
    kind<lines::Object, &Journal::objects>(),
    kind<lines::Perception, &Journal::perceptions>(),
    kind<lines::Alarm, &Journal::alarms>(),
    kind<lines::Phase, &Journal::phases>(),
    kind<lines::Operator, &Journal::operators>(),
    kind<lines::LostUav, &Journal::operators>(),
    kind<lines::FoundUav, &Journal::operators>(),
    kind<lines::Degree, &Journal::degrees>(),
    kind<lines::Fault, &Journal::faults>(),
    kind<lines::Process, &Journal::processes>(),
    kind<lines::Dropped, &Journal::dropped>(),
    kind<lines::Expired, &Journal::undelivered>(),
    kind<lines::Lost, &Journal::undelivered>(),
    kind<lines::Mission, &Journal::missions>(),
    kind<lines::Goal, &Journal::goals>(),
    kind<lines::Plan, &Journal::plans>(),
    kind<lines::Planned, &Journal::planned>(),
    kind<lines::Decision, &Journal::decisions>(),
    kind<lines::Expectation, &Journal::expectations>(),
    kind<lines::Seen, &Journal::seen>(),
    kind<lines::Air, &Journal::air>(),
    kind<lines::Meeting, &Journal::meetings>(),
    kind<lines::Frontier, &Journal::frontiers>(),
    kind<lines::Owner, &Journal::owners>(),
    kind<lines::Sale, &Journal::sales>(),
    kind<lines::Bid, &Journal::bids>(),
    kind<lines::Joint, &Journal::joints>(),
    kind<lines::RoleTask, &Journal::role_tasks>(),
    kind<lines::Scm, &Journal::scms>(),
    kind<lines::Place, &Journal::places>(),
    kind<lines::Negotiation, &Journal::negotiations>(),
};

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

/// Which goes where to be in the order of time, those of one instant as they came; empty: they are.
std::vector<std::size_t> order_of(const std::vector<MissionTime>& instants) {
  if (std::is_sorted(instants.begin(), instants.end())) return {};
  std::vector<std::size_t> order(instants.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return instants[a] < instants[b]; });
  return order;
}

template <class Record>
void sort_records(std::vector<Record>& records) {
  std::vector<MissionTime> instants;
  instants.reserve(records.size());
  for (const Record& record : records) instants.push_back(record.stamp.at);
  std::vector<Record> sorted;
  for (const std::size_t next : order_of(instants)) sorted.push_back(std::move(records[next]));
  if (!sorted.empty()) records = std::move(sorted);
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

void sort_by_time(Journal& journal) {
  std::apply([](auto&... records) { (sort_records(records), ...); }, records_of(journal));
}

}  // namespace skein::report
