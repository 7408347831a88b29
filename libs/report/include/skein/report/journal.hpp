// SPDX-License-Identifier: Apache-2.0
// The event log of one run, read into typed records.
#pragma once

#include <istream>
#include <string_view>
#include <tuple>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/journal/lines/deliberation.hpp"
#include "skein/journal/lines/joint.hpp"
#include "skein/journal/lines/mission.hpp"
#include "skein/journal/lines/team.hpp"
#include "skein/report/plan_records.hpp"
#include "skein/report/records.hpp"

namespace skein::report {

/// All lines of an events.jsonl, by kind. After reading, each vector is in the order of mission
/// time and, at equal times, of the file; a journal built by hand need not be (sort_by_time).
struct Journal {
  std::vector<TaskRecord> tasks;
  std::vector<RequestRecord> requests;
  std::vector<CommandRecord> commands;
  std::vector<SyncRecord> syncs;
  std::vector<MessageRecord> messages;
  std::vector<LinkRecord> links;
  std::vector<ReachRecord> reaches;
  std::vector<RouteRecord> routes;
  std::vector<TelemetryRecord> telemetry;
  std::vector<ObjectRecord> objects;
  std::vector<PerceptionRecord> perceptions;
  std::vector<AlarmRecord> alarms;
  std::vector<PhaseRecord> phases;
  std::vector<OperatorRecord> operators;
  std::vector<DegreeRecord> degrees;
  std::vector<FaultRecord> faults;
  std::vector<ProcessRecord> processes;
  std::vector<DroppedRecord> dropped;
  std::vector<UndeliveredRecord> undelivered;
  std::vector<MissionRecord> missions;
  std::vector<ExpectationRecord> expectations;
  std::vector<GoalRecord> goals;
  std::vector<PlanRecord> plans;
  std::vector<PlannedRecord> planned;
  std::vector<DecisionRecord> decisions;
  std::vector<Told<journal::lines::Seen>> seen;
  std::vector<Told<journal::lines::Air>> air;
  std::vector<Told<journal::lines::Meeting>> meetings;
  std::vector<Told<journal::lines::Frontier>> frontiers;
  std::vector<Told<journal::lines::Owner>> owners;
  std::vector<Told<journal::lines::Sale>> sales;
  std::vector<Told<journal::lines::Bid>> bids;
  std::vector<Told<journal::lines::Joint>> joints;
  std::vector<Told<journal::lines::RoleTask>> role_tasks;
  std::vector<Told<journal::lines::Scm>> scms;
  std::vector<Told<journal::lines::Place>> places;
  std::vector<Told<journal::lines::Negotiation>> negotiations;
  std::vector<OtherRecord> others;
  std::size_t unreadable = 0;  ///< number of wrong lines, which were left out
};

/// References to all vectors of a Journal (const or not), as a tuple.
auto records_of(auto& j) {
  return std::tie(j.tasks, j.requests, j.commands, j.syncs, j.messages, j.links, j.reaches,
                  j.routes, j.telemetry, j.objects, j.perceptions, j.alarms, j.phases, j.operators,
                  j.degrees, j.faults, j.processes, j.dropped, j.undelivered, j.missions,
                  j.expectations, j.goals, j.plans, j.planned, j.decisions, j.seen, j.air,
                  j.meetings, j.frontiers, j.owners, j.sales, j.bids, j.joints, j.role_tasks,
                  j.scms, j.places, j.negotiations, j.others);
}

/// The readable lines, and the errors of the others.
struct SalvagedJournal {
  Journal journal;
  Diagnostics errors;
};

/// Reads JSON lines. A line is wrong when it is not one JSON object of at most 64 levels, when a
/// key that its kind needs is missing or of the wrong type, or when a number is out of range (times
/// beyond ±1e8 s, other numbers beyond ±1e9): all its faults are reported, with the line number.
/// Unknown kinds and keys are kept and are no faults. Empty lines are skipped.
/// `name` is the file's name for the diagnostics. Cost: about 4 µs a line.
SalvagedJournal salvage_journal(std::istream& in, std::string_view name);

/// Like salvage_journal, but fails with all errors if any line is wrong.
Result<Journal, Diagnostics> read_journal(std::istream& in, std::string_view name);

/// Puts each vector in the order of mission time (stable).
void sort_by_time(Journal& journal);

}  // namespace skein::report
