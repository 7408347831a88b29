// SPDX-License-Identifier: Apache-2.0
#include "skein/sim/simulator.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "radio_network.hpp"
#include "skein/foundation/contract.hpp"
#include "unit.hpp"

namespace skein::sim {
namespace {

std::vector<std::string> node_names(const SimulatorConfig& config) {
  std::vector<std::string> names = {kGroundNode};
  for (const SimulatedVehicle& vehicle : config.vehicles) names.push_back(vehicle.name);
  return names;
}

bool moves_at(const world::WorldObject& object, MissionTime at) {
  const bool goes = object.speed > 0 && !object.waypoints.empty();
  return (goes || object.spread) && world::is_active(object, at);
}

/// Fires spread in its wind.
SimulatorConfig with_wind_in_fires(SimulatorConfig config) {
  for (world::WorldObject& object : config.objects)
    if (object.spread) object.spread->wind = config.wind;
  return config;
}

ObjectTruth truth_of(const world::WorldObject& object, MissionTime at,
                     const world::Terrain& terrain) {
  ObjectTruth truth{object.name,
                    object.kind,
                    world::position_at(object, at, terrain),
                    object.radius,
                    world::is_active(object, at),
                    at};
  if (!object.spread) return truth;
  truth.front = world::front_of(object, at);
  truth.radius = truth.front->length;
  return truth;
}

}  // namespace

class Simulator::Implementation {
 public:
  explicit Implementation(SimulatorConfig config)
      : config_(with_wind_in_fires(std::move(config))),
        scene_{config_.terrain, config_.objects},
        radio_(config_, node_names(config_)),
        next_step_(config_.start),
        next_telemetry_(config_.start),
        next_objects_(config_.start),
        active_(config_.objects.size(), false) {
    units_.reserve(config_.vehicles.size());
    for (const SimulatedVehicle& vehicle : config_.vehicles) {
      if (vehicle.played) units_.emplace_back(vehicle, config_, scene_);
      positions_.emplace(vehicle.name, start_of(vehicle));
    }
  }
  // The units refer to the configuration.
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  std::vector<Effect> handle(const Input& input, MissionTime now) {
    std::vector<Effect> effects;
    now_ = std::max(now_, now);
    for (; next_step_ <= now_; next_step_ = next_step_ + config_.step) step(next_step_, effects);
    std::visit([&](const auto& i) { apply(i, effects); }, input);
    return effects;
  }

  MissionTime next_step() const { return next_step_; }

  const Unit* find(std::string_view uav) const {
    const auto found = std::find_if(units_.begin(), units_.end(),
                                    [&](const Unit& unit) { return unit.name() == uav; });
    return found == units_.end() ? nullptr : &*found;
  }

 private:
  void apply(const Tick&, std::vector<Effect>&) {}

  void apply(const VehicleElsewhere& input, std::vector<Effect>&) {
    const auto known = positions_.find(input.uav);
    if (known != positions_.end() && find(input.uav) == nullptr) known->second = input.position;
  }

  void apply(const LayerForgot&, std::vector<Effect>& effects) {
    for (Unit& unit : units_) unit.forget(now_, effects);
  }

  void apply(const FunctionalRequest& input, std::vector<Effect>& effects) {
    for (Unit& unit : units_)
      if (unit.name() == input.uav) unit.handle(input.request, now_, effects);
  }

  template <class ForUnit>
  void apply(const ForUnit& input, std::vector<Effect>& effects) {
    for (Unit& unit : units_)
      if (unit.name() == input.uav) unit.handle(input, now_, effects);
  }

  /// The first step moves nothing: it tells how everything is.
  void step(MissionTime at, std::vector<Effect>& effects) {
    if (at > config_.start)
      for (Unit& unit : units_) unit.step(at, config_.step.to_seconds(), effects);
    if (config_.tells_world && radio_.due(at)) update_radio(at, effects);
    const bool telemetry = at >= next_telemetry_;
    if (config_.tells_world) tell_objects(at, telemetry, effects);
    if (!telemetry) return;
    next_telemetry_ = at + config_.telemetry_period;
    for (const Unit& unit : units_) {
      effects.push_back(Telemetry{unit.name(), unit.state(), at, unit.failed()});
      effects.push_back(VehicleTruth{unit.name(), unit.state(), at});
    }
  }

  world::Vector3 start_of(const SimulatedVehicle& vehicle) const {
    const world::Vector2& at = vehicle.start;
    return {at.x(), at.y(), config_.terrain.elevation(at.x(), at.y())};
  }

  void update_radio(MissionTime at, std::vector<Effect>& effects) {
    std::vector<world::Vector3> positions = {config_.ground_station};
    for (const Unit& unit : units_) positions_[unit.name()] = unit.state().position;
    for (const SimulatedVehicle& vehicle : config_.vehicles) {
      positions.push_back(world::eye_of(vehicle.model, positions_.at(vehicle.name)));
    }
    radio_.update(positions, config_.terrain, at, effects);
  }

  void tell_objects(MissionTime at, bool telemetry, std::vector<Effect>& effects) {
    const bool all = at >= next_objects_;
    if (all) next_objects_ = at + config_.object_period;
    for (std::size_t i = 0; i < config_.objects.size(); ++i) {
      const world::WorldObject& object = config_.objects[i];
      const bool active = world::is_active(object, at);
      const bool changed = active != active_[i] || (telemetry && moves_at(object, at));
      if (!all && !changed) continue;
      active_[i] = active;
      effects.push_back(truth_of(object, at, config_.terrain));
    }
  }

  SimulatorConfig config_;
  Scene scene_;
  RadioNetwork radio_;
  std::vector<Unit> units_;
  std::map<std::string, world::Vector3>
      positions_;  ///< of all vehicles, as the radio last had them
  MissionTime now_ = MissionTime::nanoseconds(0) - Duration::max();
  MissionTime next_step_;
  MissionTime next_telemetry_;
  MissionTime next_objects_;
  std::vector<bool> active_;  ///< of the objects, as told last
};

Simulator::Simulator(SimulatorConfig config) {
  SKEIN_EXPECTS(problems_of(config).empty());
  implementation_ = std::make_unique<Implementation>(std::move(config));
}
Simulator::~Simulator() = default;
Simulator::Simulator(Simulator&&) noexcept = default;
Simulator& Simulator::operator=(Simulator&&) noexcept = default;

std::vector<Effect> Simulator::handle(const Input& input, MissionTime now) {
  return implementation_->handle(input, now);
}

std::optional<MissionTime> Simulator::next_wakeup() const { return implementation_->next_step(); }

const world::VehicleState* Simulator::find_vehicle(std::string_view uav) const {
  const Unit* unit = implementation_->find(uav);
  return unit == nullptr ? nullptr : &unit->state();
}

}  // namespace skein::sim
