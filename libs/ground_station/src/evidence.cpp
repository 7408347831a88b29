// SPDX-License-Identifier: Apache-2.0
#include "evidence.hpp"

#include <algorithm>
#include <cmath>

namespace skein::ground_station {

using world::Likelihood;
using world::SensorEvidence;
using world::Vector3;

namespace {

const Likelihood* likelihood_of(const SensorEvidence& device, const std::string& kind) {
  const auto found = device.kinds.find(kind);
  return found == device.kinds.end() ? nullptr : &found->second;
}

}  // namespace

const SensorEvidence* evidence_of(const PpsConfig& config, const world::Perception& look) {
  const auto own = config.models.find({look.uav, look.device});
  if (own != config.models.end()) return &own->second;
  const auto found = config.devices.find(look.device);
  return found == config.devices.end() ? nullptr : &found->second;
}

bool speaks_for_fire(const SensorEvidence& device, const std::string& kind) {
  const Likelihood* likelihood = likelihood_of(device, kind);
  return likelihood != nullptr && likelihood->if_fire > likelihood->if_not_fire;
}

double log_ratio(const SensorEvidence& device, const world::Detection* detection) {
  if (detection != nullptr) {
    const Likelihood* likelihood = likelihood_of(device, detection->kind);
    if (likelihood != nullptr) return std::log(likelihood->if_fire / likelihood->if_not_fire);
  }
  double nothing_if_fire = 1;
  double nothing_if_not = 1;
  for (const auto& [kind, likelihood] : device.kinds) {
    nothing_if_fire -= likelihood.if_fire;
    nothing_if_not -= likelihood.if_not_fire;
  }
  return std::log(nothing_if_fire / nothing_if_not);
}

Duration apart(const PpsConfig& config) {
  return Duration::nanoseconds(config.decorrelation.count() / 10 * 9);
}

bool is_sane(const world::Perception& look) {
  return look.viewpoint.allFinite() && look.direction.allFinite() && look.direction.norm() > 0 &&
         std::isfinite(look.range) && std::isfinite(look.aperture);
}

bool is_sane(const world::Detection& detection) {
  return detection.position.allFinite() && std::isfinite(detection.spread) &&
         std::isfinite(detection.confidence);
}

bool surely_in_view(const world::Perception& look, const Vector3& place, double margin,
                    const world::Terrain& terrain) {
  constexpr double kEyeLevel = 2;  // [m] above the ground where a fire is looked for
  const Vector3 target = place + Vector3(0, 0, kEyeLevel);
  const Vector3 way = target - look.viewpoint;
  const double distance = way.norm();
  if (distance <= margin || distance + margin > look.range) return false;
  const double cosine = way.dot(look.direction) / (distance * look.direction.norm());
  const double off_axis = std::acos(std::clamp(cosine, -1.0, 1.0));
  return off_axis + std::asin(margin / distance) <= look.aperture &&
         terrain.line_of_sight(look.viewpoint, target);
}

double logit(double p) { return std::log(p / (1 - p)); }

double sigmoid(double log_odds) { return 1 / (1 + std::exp(-log_odds)); }

}  // namespace skein::ground_station
