// SPDX-License-Identifier: Apache-2.0
#include "skein/mavlink_node/settings.hpp"

#include <charconv>
#include <optional>

#include "skein/foundation/nearest.hpp"

namespace skein::mavlink_node {

namespace {

class Reasons {
 public:
  void add(std::string reason) { all_ += (all_.empty() ? "" : "; ") + std::move(reason); }
  /// A system or component id.
  std::uint8_t id(const char* option, const std::string& text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool sound = error == std::errc() && end == text.data() + text.size();
    if (sound && number >= 1 && number <= 255) return static_cast<std::uint8_t>(number);
    add(std::string(option) + " '" + text + "': expected a whole number from 1 to 255");
    return 1;
  }
  const std::string& text() const { return all_; }

 private:
  std::string all_;
};

}  // namespace

Result<std::string, Failure> layer_of(const scenario::Scenario& scenario, const std::string& uav) {
  const scenario::UavSpec* found = scenario.find_uav(uav);
  if (found == nullptr) {
    return failure("no UAV '" + uav + "' in this scenario" +
                   did_you_mean(nearest_name(uav, scenario.uav_names())));
  }
  const std::string& layer = found->functional;
  if (layer.empty())
    return failure("'" + uav + "' is played by the simulator: name its functional layer (uavs: " +
                   uav + ": {functional: NAME, …})");
  for (const auto& [other, its] : scenario.functional_layers()) {
    if (other != uav && its == layer)
      return failure("'" + layer + "' is the functional layer of '" + uav + "' and '" + other +
                     "': skein-mavlink flies one vehicle, so give each its own");
  }
  return layer;
}

Result<autopilot::BridgeConfig, Failure> bridge_config_of(const scenario::Scenario& scenario,
                                                          const std::string& uav,
                                                          const Settings& settings) {
  const scenario::UavSpec* spec = scenario.find_uav(uav);
  if (spec == nullptr) return failure("no UAV '" + uav + "'");
  autopilot::BridgeConfig config{.uav = uav,
                                 .model = spec->model,
                                 .terrain = world::Terrain(scenario.world.terrain),
                                 .origin = scenario.world.origin};
  config.start = spec->start;
  config.energy = spec->energy;
  Reasons reasons;
  if (!spec->model.hovers)
    reasons.add("'" + uav + "' cannot hover: skein-mavlink flies copters only");
  config.own.system = reasons.id("--own-id", settings.own_id);
  config.camera = reasons.id("--camera", settings.camera);
  if (settings.system_id != "any") config.system = reasons.id("--system-id", settings.system_id);
  config.dialect = autopilot::dialect_from(settings.dialect);
  if (!config.dialect && settings.dialect != "auto")
    reasons.add("--dialect '" + settings.dialect + "': expected px4, ardupilot or auto");
  if (!reasons.text().empty()) return failure(reasons.text());
  return config;
}

}  // namespace skein::mavlink_node
