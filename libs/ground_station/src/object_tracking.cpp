// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/object_tracking.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "device_name.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/world/sensor_model.hpp"

namespace skein::ground_station {
namespace {

constexpr double kLeastSpread = 1;  ///< of a detection, whatever the sensor says [m]
constexpr double kGate = 4;         ///< [standard deviations]
/// Looks over what was seen once before it counts as a false alarm: a sensor that sees an object in
/// 70 of 100 looks misses it so often in a row in 3 of 100.
constexpr int kMisses = 3;
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

/// The detection of its kind that is nearest to `place`, of those within `reach` of it.
template <class Reach>
const world::Detection* nearest_of(const std::string& kind, const world::Vector3& place,
                                   const world::Perception& look, const Reach& reach) {
  const world::Detection* nearest = nullptr;
  for (const world::Detection& one : look.detections) {
    if (one.kind != kind || !is_sane(one)) continue;
    const double off = distance(one.position, place);
    if (off <= reach(one) && (nearest == nullptr || off < distance(nearest->position, place)))
      nearest = &one;
  }
  return nearest;
}

}  // namespace

ObjectTracking::ObjectTracking(std::vector<ObjectSpec> objects) {
  SKEIN_EXPECTS(problems_of(objects).empty());
  for (ObjectSpec& one : objects) {
    Track track;
    track.spec = std::move(one);
    tracks_.push_back(std::move(track));
  }
}

std::vector<ObjectSeen> ObjectTracking::handle(const world::Perception& look) {
  std::vector<ObjectSeen> news;
  for (Track& track : tracks_) {
    if (const world::Detection* sighting = sighting_of(track, look)) {
      follow(track, *sighting, look.at);
    } else {
      if (!track.sure) look_for(track, look);
      continue;
    }
    if (track.told && *track.seen - *track.told < kToldEvery) continue;
    track.told = track.seen;
    news.push_back(
        {track.spec.name, track.spec.kind, track.position, std::sqrt(track.variance), *track.seen});
  }
  return news;
}

const world::Detection* ObjectTracking::sighting_of(const Track& track,
                                                    const world::Perception& look) {
  if (!track.seen) return nullptr;
  const double age = std::max(0.0, (look.at - *track.seen).to_seconds());
  const double variance = track.variance + track.spec.drift * track.spec.drift * age;
  return nearest_of(track.spec.kind, track.position, look, [&](const world::Detection& one) {
    return kGate * std::sqrt(variance + variance_of(one));
  });
}

const world::Detection* ObjectTracking::first_of(const Track& track,
                                                 const world::Perception& look) {
  return nearest_of(track.spec.kind, track.spec.thought, look,
                    [&](const world::Detection&) { return track.spec.reach; });
}

void ObjectTracking::look_for(Track& track, const world::Perception& look) {
  if (const world::Detection* first = first_of(track, look)) return begin(track, *first, look);
  const world::View view{look.viewpoint, look.direction, look.range, look.aperture};
  const bool same = track.seen && look.at > *track.seen && device_of(look) == track.by;
  if (same && world::in_view(view, track.position) && ++track.misses == kMisses) track.seen.reset();
}

void ObjectTracking::begin(Track& track, const world::Detection& sighting,
                           const world::Perception& look) {
  track.position = sighting.position;
  track.variance = variance_of(sighting);
  track.seen = look.at;
  track.by = device_of(look);
  track.misses = 0;
}

// One that is older than what is known has grown as uncertain meanwhile as the object has moved.
void ObjectTracking::follow(Track& track, const world::Detection& sighting, MissionTime at) {
  const double drift = track.spec.drift * track.spec.drift;
  double noise = variance_of(sighting);
  track.sure = true;
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
