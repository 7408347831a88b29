// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/object_tracking.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "skein/foundation/contract.hpp"

namespace skein::ground_station {
namespace {

constexpr double kLeastSpread = 1;  ///< of a detection, whatever the sensor says [m]
constexpr double kGate = 4;         ///< [standard deviations]
constexpr Duration kToldEvery = Duration::milliseconds(1'000);

bool is_sane(const world::Detection& detection) {
  return detection.position.allFinite() && std::isfinite(detection.spread);
}

double variance_of(const world::Detection& detection) {
  const double spread = std::max(detection.spread, kLeastSpread);
  return spread * spread;
}

double distance(const world::Vector3& a, const world::Vector3& b) {
  return (a - b).head<2>().norm();
}

}  // namespace

std::vector<std::string> problems_of(const std::vector<ObjectSpec>& objects) {
  std::vector<std::string> problems;
  std::set<std::string> names;
  for (const ObjectSpec& one : objects) {
    const std::string which = "object '" + one.name + "': ";
    if (one.name.empty()) problems.emplace_back("an object has a name");
    if (!names.insert(one.name).second) problems.push_back(which + "the name is taken");
    if (one.kind.empty()) problems.push_back(which + "no kind");
    if (!one.thought.allFinite()) problems.push_back(which + "its place is not finite");
    if (!(one.reach > 0) || !std::isfinite(one.reach))
      problems.push_back(which + "reach must be positive");
    if (!(one.drift > 0) || !std::isfinite(one.drift))
      problems.push_back(which + "drift must be positive");
  }
  return problems;
}

ObjectTracking::ObjectTracking(std::vector<ObjectSpec> objects) {
  SKEIN_EXPECTS(problems_of(objects).empty());
  for (ObjectSpec& one : objects) {
    Track track;
    track.position = one.thought;
    track.spec = std::move(one);
    tracks_.push_back(std::move(track));
  }
}

std::vector<ObjectSeen> ObjectTracking::handle(const world::Perception& look) {
  std::vector<ObjectSeen> news;
  for (Track& track : tracks_) {
    const world::Detection* sighting = sighting_of(track, look);
    if (sighting == nullptr) continue;
    follow(track, *sighting, look.at);
    if (track.told && *track.seen - *track.told < kToldEvery) continue;
    track.told = track.seen;
    news.push_back(
        {track.spec.name, track.spec.kind, track.position, std::sqrt(track.variance), *track.seen});
  }
  return news;
}

const world::Detection* ObjectTracking::sighting_of(const Track& track,
                                                    const world::Perception& look) {
  const double age = track.seen ? std::max(0.0, (look.at - *track.seen).to_seconds()) : 0;
  const double variance = track.variance + track.spec.drift * track.spec.drift * age;
  const world::Detection* nearest = nullptr;
  for (const world::Detection& one : look.detections) {
    if (one.kind != track.spec.kind || !is_sane(one)) continue;
    const double gate =
        track.seen ? kGate * std::sqrt(variance + variance_of(one)) : track.spec.reach;
    const double off = distance(one.position, track.position);
    if (off <= gate && (nearest == nullptr || off < distance(nearest->position, track.position)))
      nearest = &one;
  }
  return nearest;
}

// One that is older than what is known has grown as uncertain meanwhile as the object has moved.
void ObjectTracking::follow(Track& track, const world::Detection& sighting, MissionTime at) {
  const double drift = track.spec.drift * track.spec.drift;
  double noise = variance_of(sighting);
  if (!track.seen) {
    track.position = sighting.position;
    track.variance = noise;
    track.seen = at;
    return;
  }
  const double age = (at - *track.seen).to_seconds();
  if (age >= 0) {
    track.variance += drift * age;
    track.seen = at;
  } else {
    noise -= drift * age;
  }
  const double gain = track.variance / (track.variance + noise);
  track.position += gain * (sighting.position - track.position);
  track.variance *= 1 - gain;
}

}  // namespace skein::ground_station
