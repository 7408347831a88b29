// SPDX-License-Identifier: Apache-2.0
// Conformance test of a functional layer: acts as its decision node and checks its answers.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/functional/port.hpp"
#include "skein/world/perception.hpp"
#include "skein/world/telemetry.hpp"

namespace skein::conformance {

struct Config {
  double height = 30;  ///< of the takeoff, over the ground [m]
  double reach = 60;   ///< distance of way-points from the start [m]
  double near = 10;    ///< distance at which a way-point counts as reached [m]
  bool hovers = true;  ///< false: the vehicle may circle instead of staying at a place
  std::string device;  ///< sensor for perception tasks; empty: none, and none are requested
  Duration telemetry_within = Duration::seconds(2);  ///< longest gap between two samples
  Duration answer_within = Duration::seconds(10);    ///< includes a pilot's reaction
  Duration act_within = Duration::seconds(300);      ///< for a takeoff, a path, a landing
  /// Time for the caller to kill and restart the functional layer; absent: it cannot, and the
  /// points about restarts are left out.
  std::optional<Duration> restart_within;
};

/// Time passes.
struct Tick {};
/// The functional layer has restarted (a new incarnation was heard) and lost its memory.
struct Restarted {};
using Input =
    std::variant<Tick, functional::Status, world::Telemetry, world::Perception, Restarted>;

/// One point of the contract (docs/functional-layer.md).
struct Verdict {
  std::string point;  ///< "an unknown type is refused with a reason"
  bool kept = false;
  std::string seen;  ///< the observed behaviour; empty when the point was kept
  bool operator==(const Verdict&) const = default;
};

/// Sends the requests of a decision node, one point of the contract after the other: first requests
/// that must be refused on the ground, then a takeoff, paths, perception and waiting with
/// interruptions and repetitions, a landing. A violated point gets a negative verdict, and the next
/// one follows; if the vehicle does not fly, all points of the flight are violated. Precondition:
/// the vehicle stands on open ground at its first telemetry.
///
/// `now` never decreases. Deterministic. Source: spec 1.1, 2.1; docs/functional-layer.md.
class Conformance {
 public:
  explicit Conformance(Config config);

  /// Returns the requests to send to the functional layer.
  std::vector<functional::Request> handle(const Input& input, MissionTime now);
  /// When the next Tick is due.
  std::optional<MissionTime> next_wakeup() const;
  bool done() const { return point_ >= points_.size(); }
  /// Whether the caller has to kill and restart the functional layer now.
  bool wants_restart() const;
  /// Verdicts so far, in the order of the contract; complete when done().
  const std::vector<Verdict>& verdicts() const { return verdicts_; }

 private:
  /// Inputs since the current point began.
  struct Seen {
    MissionTime began;
    std::vector<functional::Status> statuses;
    std::vector<world::Telemetry> telemetry;
    std::vector<world::Perception> perceptions;
    bool restarted = false;
  };
  /// Absent: not decided yet. Empty: kept. Else the violation.
  using Judgement = std::optional<std::string>;
  struct Point {
    std::string name;
    std::vector<functional::Request> (Conformance::*ask)();
    Judgement (Conformance::*judge)(MissionTime now) const;
    Duration within;
    bool needs_flight = false;  ///< violated without a request if the vehicle is not airborne
  };

  // conformance.cpp
  static std::vector<Point> points_of(const Config& config);
  std::vector<functional::Request> begin(MissionTime now);
  void decide(const std::string& seen);
  bool is_airborne() const;
  functional::TaskId new_task() { return functional::TaskId(next_task_++); }
  functional::Request dispatch(std::string type, functional::Parameters parameters);
  std::vector<double> point_at(double part) const;

  // asks.cpp
  std::vector<functional::Request> nothing();
  std::vector<functional::Request> nothing_new();
  std::vector<functional::Request> unknown_type();
  std::vector<functional::Request> unknown_parameter();
  std::vector<functional::Request> interrupt_of_nothing();
  std::vector<functional::Request> way();
  std::vector<functional::Request> takeoff();
  std::vector<functional::Request> the_same_again();
  std::vector<functional::Request> second_motion();
  std::vector<functional::Request> interrupt();
  std::vector<functional::Request> look();
  std::vector<functional::Request> wait();
  std::vector<functional::Request> land();

  // judgements.cpp
  Judgement tells_of_itself(MissionTime now) const;
  Judgement refused(MissionTime now) const;
  Judgement aborted(MissionTime now) const;
  Judgement runs(MissionTime now) const;
  Judgement is_up(MissionTime now) const;
  Judgement told_again(MissionTime now) const;
  Judgement arrives(MissionTime now) const;
  Judgement stays(MissionTime now) const;
  Judgement looks(MissionTime now) const;
  Judgement is_down(MissionTime now) const;
  Judgement is_back(MissionTime now) const;
  std::vector<functional::Status> of_task() const;

  Config config_;
  std::vector<Point> points_;
  std::size_t point_ = 0;
  bool begun_ = false;
  std::vector<Verdict> verdicts_;
  Seen seen_;
  std::uint64_t next_task_ = 1;
  functional::Request asked_;                  ///< last dispatched, or interrupted
  std::optional<functional::TaskId> refused_;  ///< second task, which has to be refused
  std::optional<world::Telemetry> first_, last_;
};

}  // namespace skein::conformance
