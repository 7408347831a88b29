// SPDX-License-Identifier: Apache-2.0
#include "skein/world/vehicle_model_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "sensor_model_reader.hpp"
#include "skein/config/parse.hpp"
#include "skein/config/reader.hpp"

namespace skein::world {
namespace {

using config::Range;
using config::Reader;

/// Least value of what must be greater than zero.
constexpr double kLeast = 1e-3;
/// What is wrong already compares false with everything, so that it gives no second error.
constexpr double kWrong = std::numeric_limits<double>::quiet_NaN();
constexpr Range kSpeed = {kLeast, 200, "m/s"};
constexpr Range kDistance = {kLeast, 1e5, "m"};
constexpr Range kSpread = {0, 1e4, "m"};
constexpr Range kFraction = {0, 1, ""};
constexpr Range kPower = {0, 1e6, "W"};
constexpr Range kPeriod = {0.01, 3600, "s"};
constexpr Range kDelay = {0, 3600, "s"};

Duration seconds(const Reader& reader, Range range) {
  return Duration::seconds(reader.number(range.low, range));
}

EnergyModel read_energy(const Reader& reader, bool drives) {
  if (drives)
    reader.keys({"capacity", "ground", "cruise", "climb", "reserve"});
  else
    reader.keys({"capacity", "ground", "hover", "cruise", "climb", "reserve"});
  EnergyModel energy;
  energy.capacity = reader.required("capacity").number(1, {1, 1e12, "J"});
  energy.ground_power = reader.optional("ground").number(0, kPower);
  // It stands where one that hovers would.
  energy.hover_power = drives ? energy.ground_power : reader.required("hover").number(0, kPower);
  energy.cruise_power = reader.required("cruise").number(0, kPower);
  energy.climb_power = reader.optional("climb").number(0, kPower);
  energy.reserve = reader.required("reserve").number(0, {0, 0.9, ""});
  return energy;
}

std::optional<PilotModel> read_pilot(const Reader& reader) {
  if (!reader.present()) return std::nullopt;
  reader.keys({"reaction", "reaction_spread", "position_imprecision", "heading_imprecision",
               "attention_period"});
  PilotModel pilot;
  pilot.reaction = seconds(reader.required("reaction"), {0, 60, "s"});
  pilot.reaction_spread = seconds(reader.required("reaction_spread"), {0, 60, "s"});
  pilot.position_imprecision = reader.required("position_imprecision").number(0, kSpread);
  pilot.heading_imprecision =
      reader.required("heading_imprecision").number(0, {0, std::numbers::pi, "rad"});
  pilot.attention_period = seconds(reader.required("attention_period"), kPeriod);
  return pilot;
}

void read_speeds(const Reader& reader, VehicleModel& model) {
  reader.keys({"min", "cruise", "max"});
  const Reader min = reader.optional("min");
  model.min_speed = min.number(min.present() ? kWrong : 0, {0, kSpeed.high, kSpeed.unit});
  model.cruise_speed = reader.required("cruise").number(kWrong, kSpeed);
  model.max_speed = reader.required("max").number(kWrong, kSpeed);
  if (model.cruise_speed > model.max_speed)
    reader.error("cruise is greater than max", "min <= cruise <= max");
  if (model.min_speed > model.cruise_speed)
    reader.error("min is greater than cruise", "min <= cruise <= max");
}

/// What a vehicle that hovers has and what one that cannot has exclude each other.
void read_manoeuvre(const Reader& reader, VehicleModel& model) {
  const std::array<const char*, 2> circles = {"min_turn_radius", "orbit_radius"};
  if (model.hovers) {
    model.yaw_rate = reader.required("yaw_rate").number(1, {kLeast, 10, "rad/s"});
    for (const char* key : circles)
      if (const Reader entry = reader.optional(key); entry.present())
        entry.error(std::string(key) + " of a vehicle that hovers",
                    "hovers: false, or no such key");
    if (model.min_speed > 0)
      reader.optional("speed").optional("min").error("a least speed of a vehicle that hovers",
                                                     "hovers: false, or no such key");
    return;
  }
  model.min_turn_radius = reader.required(circles[0]).number(kWrong, kDistance);
  model.orbit_radius = reader.required(circles[1]).number(kWrong, kDistance);
  if (model.orbit_radius < 1.1 * model.min_turn_radius)
    reader.optional(circles[1])
        .error("the orbit is too tight to be flown", "at least 1.1 times min_turn_radius");
  if (const Reader yaw = reader.optional("yaw_rate"); yaw.present())
    yaw.error("yaw_rate of a vehicle that cannot hover", "hovers: true, or no such key");
  if (model.min_speed <= 0 && reader.optional("speed").present())
    reader.optional("speed").error("a vehicle that cannot hover needs a least speed",
                                   "min greater than 0");
}

void read_flight(const Reader& reader, VehicleModel& model) {
  model.hovers = reader.required("hovers").boolean(true);
  read_speeds(reader.required("speed"), model);
  model.climb_rate = reader.required("climb_rate").number(kSpeed.low, kSpeed);
  model.descent_rate = reader.required("descent_rate").number(kSpeed.low, kSpeed);
  model.acceleration = reader.required("acceleration").number(1, {0.01, 100, "m/s²"});
  model.ceiling = reader.required("ceiling").number(kDistance.low, kDistance);
  model.body_radius = reader.optional("body_radius").number(1, {0.01, 100, "m"});
  model.position_precision = reader.required("position_precision").number(0, kSpread);
  model.wind_drift = reader.required("wind_drift").number(0, kFraction);
  read_manoeuvre(reader, model);
}

/// What is left of a vehicle that keeps to the ground.
void read_driving(const Reader& reader, VehicleModel& model) {
  for (const char* key : {"hovers", "climb_rate", "descent_rate", "min_turn_radius", "orbit_radius",
                          "ceiling", "wind_drift"})
    if (const Reader entry = reader.optional(key); entry.present())
      entry.error(std::string(key) + " of a vehicle that keeps to the ground", "no such key");
  const Reader speed = reader.required("speed");
  read_speeds(speed, model);
  if (model.min_speed > 0)
    speed.optional("min").error("a least speed of a vehicle that keeps to the ground",
                                "no such key");
  model.acceleration = reader.required("acceleration").number(1, {0.01, 100, "m/s²"});
  model.yaw_rate = reader.required("yaw_rate").number(1, {kLeast, 10, "rad/s"});
  model.body_radius = reader.optional("body_radius").number(1, {0.01, 100, "m"});
  model.position_precision = reader.required("position_precision").number(0, kSpread);
  const Reader ground = reader.required("ground");
  ground.keys({"steepest", "mast"});
  GroundModel drives;
  drives.steepest = ground.required("steepest").number(0.1, {0.01, 1.2, "rad"});
  drives.mast = ground.required("mast").number(1, {0.05, 50, "m"});
  model.ground = drives;
  model.climb_rate = model.descent_rate =
      std::max(kLeast, model.max_speed * std::tan(drives.steepest));
}

}  // namespace

void read_abilities(const Reader& reader, VehicleModel& model) {
  constexpr std::array known = {"hovering", "relay",   "radio",    "camera",
                                "speed",    "ceiling", "endurance"};
  for (const auto& [name, figure] : reader.entries()) {
    const bool is_known =
        std::any_of(known.begin(), known.end(), [&n = name](const char* one) { return n == one; });
    const bool is_range = std::any_of(
        model.sensors.begin(), model.sensors.end(),
        [&n = name](const SensorModel& sensor) { return n == sensor.device + "-range"; });
    if (is_known || is_range)
      figure.error("'" + name + "' follows from the rest of the model", "another name");
    model.abilities[name] = figure.number(0, {-1e12, 1e12, ""});
  }
}

VehicleModel read_vehicle_model(const Reader& reader) {
  constexpr std::array kinds = {VehicleKind::kHelicopter, VehicleKind::kBlimp,
                                VehicleKind::kFixedWing, VehicleKind::kGround};
  reader.keys({"model", "kind", "hovers", "speed", "climb_rate", "descent_rate", "acceleration",
               "yaw_rate", "min_turn_radius", "orbit_radius", "ceiling", "body_radius",
               "position_precision", "wind_drift", "ground", "energy", "pilot", "sensors",
               "abilities"});
  VehicleModel model;
  model.name = reader.required("model").text();
  if (reader.optional("model").present() && model.name.empty())
    reader.optional("model").error("an empty name");
  model.kind =
      kinds[reader.required("kind").choice({"helicopter", "blimp", "fixed-wing", "ground"})];
  const bool drives = model.kind == VehicleKind::kGround;
  if (drives)
    read_driving(reader, model);
  else
    read_flight(reader, model);
  if (const Reader ground = reader.optional("ground"); !drives && ground.present())
    ground.error("ground of a vehicle that flies", "kind: ground, or no such key");
  model.energy = read_energy(reader.required("energy"), drives);
  model.pilot = read_pilot(reader.optional("pilot"));
  for (const auto& [device, entry] : reader.optional("sensors").entries()) {
    if (!entry.present()) entry.error("missing", "a map that describes the sensor");
    model.sensors.push_back(read_sensor(device, entry));
  }
  read_abilities(reader.optional("abilities"), model);
  return model;
}

Result<VehicleModel, Diagnostics> read_vehicle_model(std::string_view text,
                                                     const std::string& file) {
  const auto document = config::parse_yaml(text, file);
  if (!document) return tl::make_unexpected(document.error());
  Diagnostics diagnostics;
  const Reader reader(*document, file, diagnostics);
  if (!reader.is_map()) {
    reader.error("this is not a vehicle model", "a map that begins with model: NAME");
    return tl::make_unexpected(diagnostics);
  }
  VehicleModel model = read_vehicle_model(reader);
  if (!diagnostics.empty()) return tl::make_unexpected(diagnostics);
  return model;
}

}  // namespace skein::world
