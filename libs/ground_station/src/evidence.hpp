// SPDX-License-Identifier: Apache-2.0
// Evidence of one look on one place.
#pragma once

#include "skein/ground_station/perception_processing.hpp"

namespace skein::ground_station {

/// The evidence model of the look's device: that of its UAV's model, else by the device's name;
/// null: its looks are no evidence.
const world::SensorEvidence* evidence_of(const PpsConfig& config, const world::Perception& look);

bool speaks_for_fire(const world::SensorEvidence& device, const std::string& kind);

/// ln P(outcome | fire) / P(outcome | no fire); no detection, or one of a kind that is not known:
/// nothing reported.
double log_ratio(const world::SensorEvidence& device, const world::Detection* detection);

/// Least time between looks of one device that both count: nine tenths of the decorrelation time,
/// since the period of a device varies by milliseconds.
Duration apart(const PpsConfig& config);

/// All figures are finite, and the direction of view is not zero.
bool is_sane(const world::Perception& look);
bool is_sane(const world::Detection& detection);

/// Whether a disc of radius `margin` [m] around a place on the ground is wholly in the cone, in
/// range and in line of sight.
bool surely_in_view(const world::Perception& look, const world::Vector3& place, double margin,
                    const world::Terrain& terrain);

double logit(double p);
double sigmoid(double log_odds);

}  // namespace skein::ground_station
