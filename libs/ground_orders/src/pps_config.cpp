// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_orders/pps_config.hpp"

#include <cmath>

namespace skein::ground_station {
namespace {

using world::SensorEvidence;

bool is_probability(double p) { return p > 0 && p < 1; }

void check_device(const std::string& name, const SensorEvidence& device,
                  std::vector<std::string>& problems) {
  const std::string where = "device " + name;
  double if_fire = 0;
  double if_not_fire = 0;
  for (const auto& [kind, likelihood] : device.kinds) {
    if (!is_probability(likelihood.if_fire) || !is_probability(likelihood.if_not_fire)) {
      problems.push_back(where + ", kind " + kind + ": likelihoods must be above 0 and below 1");
    }
    if_fire += likelihood.if_fire;
    if_not_fire += likelihood.if_not_fire;
  }
  if (!(if_fire < 1) || !(if_not_fire < 1)) {
    problems.push_back(where + ": the likelihoods of its kinds must add up to less than 1");
  }
  if (!(device.limit > 0) || !std::isfinite(device.limit)) {
    problems.push_back(where + ": limit must be positive");
  }
}

}  // namespace

std::map<std::string, SensorEvidence, std::less<>> default_devices() {
  return {
      {"fire-sensor", {.kinds = {{"fire", {0.8, 0.1}}}, .confirms = false, .limit = 5}},
      {"ir", {.kinds = {{"fire", {0.85, 0.1}}}, .confirms = false, .limit = 4}},
      {"visible",
       {.kinds = {{"fire", {0.8, 0.02}},
                  {"smoke", {0.1, 0.02}},
                  {"hot-vehicle", {0.01, 0.2}},
                  {"vehicle", {0.01, 0.2}}},
        .confirms = true,
        .limit = 12}},
      {"mapping", {.kinds = {{"fire", {0.5, 0.1}}}, .confirms = false, .limit = 3}},
  };
}

std::vector<std::string> problems_of(const PpsConfig& config) {
  std::vector<std::string> problems;
  for (const auto& [name, device] : config.devices) check_device(name, device, problems);
  for (const auto& [name, device] : config.models)
    check_device(name.second + " of " + name.first, device, problems);
  if (!(0 < config.infirm && config.infirm < config.prior && config.prior < config.raise &&
        config.raise <= config.confirm && config.confirm < 1)) {
    problems.emplace_back("thresholds must be in order: 0 < infirm < prior < raise <= confirm < 1");
  }
  if (!(config.gate > 0)) problems.emplace_back("gate must be positive");
  if (!(config.least_separation >= 0))
    problems.emplace_back("least_separation must not be negative");
  if (!(config.least_spread > 0)) problems.emplace_back("least_spread must be positive");
  if (!(config.refine_distance > 0)) problems.emplace_back("refine_distance must be positive");
  if (config.decorrelation < Duration())
    problems.emplace_back("decorrelation must not be negative");
  if (config.tell_again < Duration()) problems.emplace_back("tell_again must not be negative");
  if (config.forget <= Duration()) problems.emplace_back("forget must be positive");
  return problems;
}

}  // namespace skein::ground_station
