// SPDX-License-Identifier: Apache-2.0
// PPS: fuses detections and missing detections of all sensors into alarms with a fire model.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/ground_orders/alarm.hpp"
#include "skein/ground_orders/pps_config.hpp"
#include "skein/world/perception.hpp"
#include "skein/world/terrain.hpp"

namespace skein::ground_station {

/// A perception with at least one detection arrived; for the journal.
struct PerceptionLogged {
  std::string uav;
  std::string device;
  std::size_t detections = 0;
};

/// A candidate is a place where some device reported fire. Its belief b starts at the prior and, by
/// Bayes' rule, each look adds to ln(b / (1 - b))
///   ln(P(look | fire) / P(look | no fire)),
/// where the sum over the looks of each device is kept within ±limit after every look (so that a
/// device whose reports change has an effect at once). At most one look per `decorrelation` (less a
/// tenth, since looks are early or late by milliseconds) and device counts (late looks, up to two
/// minutes, are checked against younger ones). The outcome of a look is the kind detected within
/// the gate (or `least_separation`), or "nothing" if the candidate's place with its uncertainty was
/// wholly in the cone, in range and in line of sight.
///
/// | from      | when                                                                | to        |
/// | candidate | belief >= raise                                                     | raised    |
/// | candidate | belief <= infirm, or not seen for `forget`                          | (dropped) |
/// | raised    | belief >= confirm and a confirming device has seen it               | confirmed |
/// | raised    | belief <= infirm                                                    | infirmed  |
/// | infirmed  | belief >= raise; the devices that had raised it no longer count     | raised    |
///
/// An infirmed alarm keeps its place: detections there by a device that had a part in raising it
/// (and does not confirm) change nothing and make no new alarm. "Confirmed" is final. The position
/// is the inverse-variance mean of the independent sightings, projected on the ground.
///
/// Deterministic. Not safe to share between threads. Cost of a look: O(detections × candidates).
/// Source: T VI.1.1, VI.1.2 (the algorithm is ours, the seeds give none).
class PerceptionProcessing {
 public:
  using Effect = std::variant<PerceptionLogged, AlarmEvent, AlarmRefined>;

  /// Precondition: problems_of(config) is empty. The terrain must outlive this.
  PerceptionProcessing(PpsConfig config, const world::Terrain& terrain);

  /// Adds a look. Figures that are not finite are disregarded.
  std::vector<Effect> handle(const world::Perception& look, MissionTime now);
  /// A person confirms or infirms an alarm. If infirmed, the devices that saw it no longer count
  /// for it. No effect if the alarm is unknown, confirmed, or in that state already.
  std::vector<Effect> judge(AlarmId alarm, AlarmState state);
  /// Always absent: only looks change belief.
  std::optional<MissionTime> next_wakeup() const { return std::nullopt; }

  /// All alarms ever raised, by id.
  std::vector<Alarm> alarms() const;

 private:
  /// Evidence of one device on one candidate.
  struct Tally {
    double evidence = 0;  ///< natural log-odds, within ±limit
    double limit = 0;
    bool confirms = false;
    std::deque<MissionTime> counted;  ///< times of counted looks, for the decorrelation check
    bool saw = false;                 ///< it reported a kind that speaks for fire
    bool muted = false;               ///< it had a part in raising an alarm that was infirmed
  };
  struct Candidate {
    Alarm alarm;                           ///< id 0: not raised yet
    std::map<std::string, Tally> tallies;  ///< by "uav/device"
    double weight = 0;                     ///< Σ 1/σ² of the sightings
    double scatter = 0;                    ///< Σ |residual|²/σ², horizontal
    world::Vector3 told_at = world::Vector3::Zero();
    MissionTime told_seen;
  };
  using Sightings = std::map<std::size_t, const world::Detection*>;

  const world::SensorEvidence* reliability_of(const world::Perception& look) const;
  void forget_stale(MissionTime now);
  /// Association distance of a detection with that spread from the alarm's position [m].
  double reach_of(const Alarm& alarm, double spread) const;
  std::optional<std::size_t> nearest_in_gate(const world::Detection& detection) const;
  Sightings associate(const world::Perception& look, const world::SensorEvidence& device);
  bool surely_in_view(const Candidate& candidate, const world::Perception& look) const;
  bool is_too_close(Tally& tally, MissionTime at) const;
  void count(Candidate& candidate, const world::Perception& look,
             const world::SensorEvidence& device, const world::Detection* sighting);
  void place(Candidate& candidate, const world::Perception& look, const world::Detection& sighting);
  double belief_of(const Candidate& candidate) const;
  bool confirmed_by_sight(const Candidate& candidate) const;
  void settle(Candidate& candidate, std::vector<Effect>& effects);
  void enter(Candidate& candidate, AlarmState state, std::vector<Effect>& effects);
  void drop_unlikely();

  PpsConfig config_;
  const world::Terrain& terrain_;
  std::vector<Candidate> candidates_;  ///< in the order first seen
  std::uint32_t last_id_ = 0;
};

}  // namespace skein::ground_station
