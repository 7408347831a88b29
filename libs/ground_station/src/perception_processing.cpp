// SPDX-License-Identifier: Apache-2.0
// Bayesian fusion of looks into alarms.
#include "skein/ground_station/perception_processing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "device_name.hpp"
#include "evidence.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::ground_station {
namespace {

using world::SensorEvidence;
using world::Vector2;
using world::Vector3;

/// A look that is older than this beside the youngest of its device has nothing to add.
constexpr Duration kLatest = Duration::milliseconds(120'000);

double horizontal(const Vector3& a, const Vector3& b) { return (a - b).head<2>().norm(); }

std::size_t sector_of(const Vector3& from, const Vector3& to) {
  const double bearing = std::atan2(to.y() - from.y(), to.x() - from.x());
  const double turn = bearing / (2 * std::numbers::pi) + (bearing < 0 ? 1 : 0);
  const auto sector = static_cast<std::size_t>(turn * Alarm::kSectors);
  return std::min(sector, std::size_t{Alarm::kSectors - 1});
}

}  // namespace

PerceptionProcessing::PerceptionProcessing(PpsConfig config, const world::Terrain& terrain)
    : config_(std::move(config)), terrain_(terrain) {
  SKEIN_EXPECTS(problems_of(config_).empty());
}

std::vector<PerceptionProcessing::Effect> PerceptionProcessing::handle(
    const world::Perception& look, MissionTime now) {
  std::vector<Effect> effects;
  if (!look.detections.empty()) {
    effects.emplace_back(PerceptionLogged{look.uav, look.device, look.detections.size()});
  }
  forget_stale(now);
  const SensorEvidence* device = reliability_of(look);
  if (device == nullptr || !is_sane(look)) return effects;

  const Sightings sightings = associate(look, *device);
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    const auto sighting = sightings.find(i);
    if (sighting != sightings.end()) {
      count(candidates_[i], look, *device, sighting->second);
    } else if (surely_in_view(candidates_[i], look)) {
      count(candidates_[i], look, *device, nullptr);
    }
  }
  drop_unlikely();  // before they are raised
  for (Candidate& candidate : candidates_) settle(candidate, effects);
  return effects;
}

std::vector<Alarm> PerceptionProcessing::alarms() const {
  std::vector<Alarm> alarms;
  for (const Candidate& candidate : candidates_) {
    if (candidate.alarm.id != AlarmId()) alarms.push_back(candidate.alarm);
  }
  std::sort(alarms.begin(), alarms.end(),
            [](const Alarm& a, const Alarm& b) { return a.id < b.id; });
  return alarms;
}

const SensorEvidence* PerceptionProcessing::reliability_of(const world::Perception& look) const {
  return evidence_of(config_, look);
}

void PerceptionProcessing::forget_stale(MissionTime now) {
  std::erase_if(candidates_, [&](const Candidate& candidate) {
    return candidate.alarm.id == AlarmId() && now - candidate.alarm.last_seen > config_.forget;
  });
}

double PerceptionProcessing::reach_of(const Alarm& alarm, double spread) const {
  const double gate = config_.gate * std::hypot(spread, alarm.position_sigma) + alarm.radius;
  return std::max(gate, config_.least_separation);
}

std::optional<std::size_t> PerceptionProcessing::nearest_in_gate(
    const world::Detection& detection) const {
  std::optional<std::size_t> nearest;
  double least = 0;
  const double spread = std::max(detection.spread, config_.least_spread);
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    const Alarm& alarm = candidates_[i].alarm;
    const double distance = horizontal(alarm.position, detection.position);
    if (distance > reach_of(alarm, spread) || (nearest && distance >= least)) continue;
    nearest = i;
    least = distance;
  }
  return nearest;
}

// Each detection goes to the nearest candidate within the gate, or makes a new one if it speaks for
// fire. Of several in one look that go to one candidate the one that speaks for fire most counts.
PerceptionProcessing::Sightings PerceptionProcessing::associate(const world::Perception& look,
                                                                const SensorEvidence& device) {
  Sightings sightings;
  for (const world::Detection& detection : look.detections) {
    if (!is_sane(detection) || detection.confidence < config_.least_confidence) continue;
    std::optional<std::size_t> index = nearest_in_gate(detection);
    if (!index) {
      if (!speaks_for_fire(device, detection.kind)) continue;
      index = candidates_.size();
      Candidate& fresh = candidates_.emplace_back();
      fresh.alarm.first_seen = look.at;
      fresh.alarm.last_seen = look.at;
      fresh.alarm.belief = config_.prior;
      fresh.alarm.position = detection.position;
    }
    const world::Detection*& kept = sightings[*index];
    if (kept == nullptr || log_ratio(device, &detection) > log_ratio(device, kept)) {
      kept = &detection;
    }
  }
  return sightings;
}

bool PerceptionProcessing::surely_in_view(const Candidate& candidate,
                                          const world::Perception& look) const {
  return ground_station::surely_in_view(look, candidate.alarm.position,
                                        candidate.alarm.position_sigma, terrain_);
}

// Else it is noted as counted. What comes by an event that was said again is older than what the
// stream brought meanwhile.
bool PerceptionProcessing::is_too_close(Tally& tally, MissionTime at) const {
  std::deque<MissionTime>& counted = tally.counted;
  const Duration kept = std::max(kLatest, config_.decorrelation);
  const MissionTime youngest = counted.empty() ? at : std::max(at, counted.back());
  while (!counted.empty() && youngest - counted.front() > kept) counted.pop_front();
  if (youngest - at > kept) return true;
  const auto next = std::lower_bound(counted.begin(), counted.end(), at);
  const Duration least = apart(config_);
  if (next != counted.end() && *next - at < least) return true;
  if (next != counted.begin() && at - *std::prev(next) < least) return true;
  counted.insert(next, at);
  return false;
}

void PerceptionProcessing::count(Candidate& candidate, const world::Perception& look,
                                 const SensorEvidence& device, const world::Detection* sighting) {
  Tally& tally = candidate.tallies[device_of(look)];
  const bool for_fire = sighting != nullptr && speaks_for_fire(device, sighting->kind);
  if (for_fire) candidate.alarm.last_seen = std::max(candidate.alarm.last_seen, look.at);
  if (tally.muted) return;
  if (is_too_close(tally, look.at)) return;
  tally.limit = device.limit;
  tally.confirms = device.confirms;
  tally.evidence =
      std::clamp(tally.evidence + log_ratio(device, sighting), -tally.limit, tally.limit);
  if (for_fire) {
    tally.saw = true;
    place(candidate, look, *sighting);
  }
  candidate.alarm.belief = belief_of(candidate);
}

void PerceptionProcessing::place(Candidate& candidate, const world::Perception& look,
                                 const world::Detection& sighting) {
  Alarm& alarm = candidate.alarm;
  const double sigma = std::max(sighting.spread, config_.least_spread);
  const double weight = 1 / (sigma * sigma);
  const Vector2 seen_at = sighting.position.head<2>();
  const Vector2 before = alarm.position.head<2>();
  candidate.weight += weight;
  const Vector2 mean = before + weight / candidate.weight * (seen_at - before);
  candidate.scatter += weight * (seen_at - before).dot(seen_at - mean);
  alarm.position = Vector3(mean.x(), mean.y(), terrain_.elevation(mean.x(), mean.y()));
  alarm.position_sigma = 1 / std::sqrt(candidate.weight);
  alarm.views += 1;
  alarm.views_by_bearing[sector_of(alarm.position, look.viewpoint)] += 1;
  // A uniform disc of radius R has variance R²/4 on each axis; the sensors' own errors make up
  // 2 (n - 1) of the normalised scatter.
  const double excess = (candidate.scatter - 2.0 * (alarm.views - 1)) / (2 * candidate.weight);
  alarm.radius = 2 * std::sqrt(std::max(0.0, excess));
}

double PerceptionProcessing::belief_of(const Candidate& candidate) const {
  double log_odds = logit(config_.prior);
  for (const auto& [key, tally] : candidate.tallies) log_odds += tally.evidence;
  return sigmoid(log_odds);
}

bool PerceptionProcessing::confirmed_by_sight(const Candidate& candidate) const {
  return std::any_of(candidate.tallies.begin(), candidate.tallies.end(), [](const auto& entry) {
    return entry.second.confirms && entry.second.saw && entry.second.evidence > 0;
  });
}

// The transitions of the table in the header, in its order.
void PerceptionProcessing::settle(Candidate& candidate, std::vector<Effect>& effects) {
  Alarm& alarm = candidate.alarm;
  const bool is_candidate = alarm.id == AlarmId();
  if ((is_candidate || alarm.state == AlarmState::kInfirmed) && alarm.belief >= config_.raise) {
    if (is_candidate) alarm.id = AlarmId(++last_id_);
    enter(candidate, AlarmState::kRaised, effects);
  }
  if (alarm.id == AlarmId()) return;
  if (alarm.state == AlarmState::kRaised) {
    if (alarm.belief >= config_.confirm && confirmed_by_sight(candidate)) {
      enter(candidate, AlarmState::kConfirmed, effects);
    } else if (alarm.belief <= config_.infirm) {
      for (auto& [key, tally] : candidate.tallies) tally.muted = tally.saw && !tally.confirms;
      enter(candidate, AlarmState::kInfirmed, effects);
    }
  }
  const bool again = config_.tell_again > Duration() &&
                     alarm.last_seen - candidate.told_seen >= config_.tell_again;
  if (again || horizontal(alarm.position, candidate.told_at) >= config_.refine_distance) {
    effects.emplace_back(AlarmRefined{alarm});
    candidate.told_at = alarm.position;
    candidate.told_seen = alarm.last_seen;
  }
}

std::vector<PerceptionProcessing::Effect> PerceptionProcessing::judge(AlarmId alarm,
                                                                      AlarmState state) {
  std::vector<Effect> effects;
  for (Candidate& candidate : candidates_) {
    const bool is_meant = alarm != AlarmId() && candidate.alarm.id == alarm;
    const bool can_change = candidate.alarm.state != AlarmState::kConfirmed &&
                            candidate.alarm.state != state && state != AlarmState::kRaised;
    if (!is_meant || !can_change) continue;
    if (state == AlarmState::kInfirmed) {
      for (auto& [key, tally] : candidate.tallies) {
        tally.muted = true;
        tally.evidence = 0;
      }
      candidate.alarm.belief = belief_of(candidate);
    }
    enter(candidate, state, effects);
  }
  return effects;
}

void PerceptionProcessing::enter(Candidate& candidate, AlarmState state,
                                 std::vector<Effect>& effects) {
  candidate.alarm.state = state;
  candidate.told_at = candidate.alarm.position;
  candidate.told_seen = candidate.alarm.last_seen;
  effects.emplace_back(AlarmEvent{candidate.alarm});
}

// Besides those no longer believed in, those that turn out to be an older one seen with a large
// error.
void PerceptionProcessing::drop_unlikely() {
  for (std::size_t i = candidates_.size(); i-- > 0;) {
    const Alarm& alarm = candidates_[i].alarm;
    if (alarm.id != AlarmId()) continue;
    bool drop = alarm.belief <= config_.infirm;
    for (std::size_t j = 0; j < i && !drop; ++j) {
      const Alarm& older = candidates_[j].alarm;
      drop = horizontal(alarm.position, older.position) <= reach_of(older, alarm.position_sigma);
    }
    if (drop) candidates_.erase(candidates_.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

}  // namespace skein::ground_station
