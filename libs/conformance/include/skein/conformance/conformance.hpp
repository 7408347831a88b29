// SPDX-License-Identifier: Apache-2.0
// Plays a decision node against a functional layer and says what is wrong with it.
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
  double height = 30;  ///< over the ground that it takes off to [m]
  double reach = 60;   ///< how far from its start it is sent [m]
  double near = 10;    ///< of a way-point that counts as reached [m]
  bool hovers = true;  ///< else it may circle where it is told to stay
  std::string device;  ///< that looks; empty: none, and looking is not asked for
  Duration telemetry_within = Duration::seconds(2);  ///< between two
  Duration answer_within = Duration::seconds(10);    ///< a pilot's reaction included
  Duration act_within = Duration::seconds(300);      ///< a takeoff, a way, a landing
  /// Until somebody has killed it and started it again; absent: nobody does, and points about that
  /// are left out.
  std::optional<Duration> restart_within;
};

/// Time passes.
struct Tick {};
/// The functional layer is heard in a new incarnation: it has lost its memory.
struct Restarted {};
using Input =
    std::variant<Tick, functional::Status, world::Telemetry, world::Perception, Restarted>;

/// One point of the contract (docs/functional-layer.md).
struct Verdict {
  std::string point;  ///< "an unknown type is refused with a reason"
  bool kept = false;
  std::string seen;  ///< what came instead; empty when it was kept
  bool operator==(const Verdict&) const = default;
};

/// Asks what a decision node asks, one point after the other: first what is refused on the ground,
/// then a takeoff, ways, a look and a wait with their interruptions and repetitions, a landing. A
/// point that is not kept is told, and the next one follows; when it does not fly, the rest of the
/// flight is told as not kept. The vehicle stands on open ground at its first telemetry.
///
/// `now` never decreases. Deterministic. Source: spec 1.1, 2.1; docs/functional-layer.md.
class Conformance {
 public:
  explicit Conformance(Config config);

  /// What is to be sent to the functional layer.
  std::vector<functional::Request> handle(const Input& input, MissionTime now);
  /// When it next wants a Tick.
  std::optional<MissionTime> next_wakeup() const;
  bool done() const { return point_ >= points_.size(); }
  /// Now is the time to kill it and start it again.
  bool wants_restart() const;
  /// In the order of the contract; complete when done.
  const std::vector<Verdict>& verdicts() const { return verdicts_; }

 private:
  /// What came since a point began.
  struct Seen {
    MissionTime began;
    std::vector<functional::Status> statuses;
    std::vector<world::Telemetry> telemetry;
    std::vector<world::Perception> perceptions;
    bool restarted = false;
  };
  /// Absent: not decided yet. Empty: kept. Else what was seen instead.
  using Judgement = std::optional<std::string>;
  struct Point {
    std::string name;
    std::vector<functional::Request> (Conformance::*ask)();
    Judgement (Conformance::*judge)(MissionTime now) const;
    Duration within;
    bool needs_flight = false;  ///< told as not kept without being asked when it is not in the air
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
  std::optional<functional::TaskId> refused_;  ///< asked for beside it
  std::optional<world::Telemetry> first_, last_;
};

}  // namespace skein::conformance
