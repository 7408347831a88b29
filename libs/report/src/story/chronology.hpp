// SPDX-License-Identifier: Apache-2.0
// The course of a run, assembled from log records: task bars, tracks, spans, message transmissions.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "skein/report/journal.hpp"
#include "skein/report/run_info.hpp"

namespace skein::report {

/// The instant of a record [s], correctly rounded.
double seconds(const Stamp& stamp);

/// A closed span of mission time [s].
struct Span {
  double from = 0.0;
  double to = 0.0;
  bool operator==(const Span&) const = default;
};

struct TaskSegment {
  TaskState state = TaskState::kScheduled;
  Span span;
};

/// One task from its first to its last known state.
struct TaskBar {
  std::size_t uav = 0;  ///< index into Chronology::uavs
  std::uint64_t id = 0;
  std::string type;
  std::string componel = {};          ///< that asked for the task, in a role of a joint task
  std::vector<TaskSegment> segments;  ///< adjoining, in time order; without terminal states
  Span span;
  std::optional<TaskState> outcome;  ///< kEnded or kAborted; none: still alive when the log ends
  std::string reason;

  /// From started (or running) to the end; empty when it was never started.
  std::optional<Span> active() const;
  /// The first instant of a state.
  std::optional<double> first(TaskState state) const;
};

struct TrackPoint {
  double t = 0.0;
  Position position;
  double speed = 0.0;  ///< [m/s]
  double heading = 0.0;
  double energy = 1.0;
  bool airborne = false;
};

/// One UAV over the run, from its records.
struct UavStory {
  std::string name;
  std::string model;
  std::optional<int> degree;                    ///< at the start
  std::vector<TrackPoint> track;                ///< time order, instants all different
  std::vector<std::pair<double, int>> degrees;  ///< changes: instant, new degree

  /// Whether it was never airborne, so that its track is a path on the ground.
  bool keeps_to_ground() const;
};

struct NamedSpan {
  std::string name;
  Span span;
};

/// A message or synchronisation from one node to another, as far as the log shows it.
struct Flight {
  std::string what;  ///< slot, or synchronisation id
  std::string from;
  std::string to;
  std::uint64_t sequence = 0;
  std::optional<double> sent;
  std::optional<double> received;
  std::optional<SessionName> session = {};  ///< the negotiation that the message belongs to
};

/// Truth and belief about one pair of nodes; `first` < `second`.
struct LinkStory {
  std::string first;
  std::string second;
  std::vector<Span> up[2];          ///< first to second, second to first
  std::vector<Span> believed[2];    ///< second reachable for first, first reachable for second
  std::vector<Span> relayed[2];     ///< traffic via a relay: first to second, second to first
  bool truth[2] = {false, false};   ///< whether the log has link records of that direction
  bool belief[2] = {false, false};  ///< whether the log has reach records of that direction
};

struct AlarmStory {
  std::uint64_t id = 0;
  Position position;  ///< the last estimate
  double belief = 0.0;
  AlarmState state = AlarmState::kRaised;  ///< the last one
  std::vector<std::pair<double, AlarmState>> steps;
};

struct ObjectStory {
  std::string name;
  std::string type;
  std::vector<ObjectRecord> states;  ///< time order
};

/// The run as the views draw it.
struct Chronology {
  Span time;  ///< of the whole run; at least one second long
  std::vector<UavStory> uavs;
  std::vector<TaskBar> tasks;  ///< by UAV, then by first instant
  std::vector<NamedSpan> phases;
  std::vector<Flight> syncs;
  std::vector<Flight> messages;
  std::vector<LinkStory> links;
  std::vector<AlarmStory> alarms;
  std::vector<ObjectStory> objects;

  std::optional<std::size_t> uav_index(const std::string& name) const;
};

/// Precondition: the journal is in time order (sort_by_time).
Chronology tell(const RunInfo& info, const Journal& journal);

/// The state of a track at `t`, linear between its points; none outside it.
std::optional<TrackPoint> at(const std::vector<TrackPoint>& track, double t);

/// The state at `t` between two track points. Precondition: `a` is not later than `b`.
std::optional<TrackPoint> between(const TrackPoint& a, const TrackPoint& b, double t);

}  // namespace skein::report
