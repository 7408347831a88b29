// SPDX-License-Identifier: Apache-2.0
#include "skein/negotiation/area_offer.hpp"

#include <array>

#include "row_words.hpp"
#include "skein/refiners/checks.hpp"

namespace skein::interaction {

namespace {

using world::EnergyModel;
using world::VehicleModel;

constexpr std::array kFigures = {
    &VehicleModel::min_speed,  &VehicleModel::cruise_speed,       &VehicleModel::max_speed,
    &VehicleModel::climb_rate, &VehicleModel::descent_rate,       &VehicleModel::acceleration,
    &VehicleModel::yaw_rate,   &VehicleModel::min_turn_radius,    &VehicleModel::orbit_radius,
    &VehicleModel::ceiling,    &VehicleModel::position_precision, &VehicleModel::wind_drift};
constexpr std::array kEnergyFigures = {&EnergyModel::capacity,    &EnergyModel::ground_power,
                                       &EnergyModel::hover_power, &EnergyModel::cruise_power,
                                       &EnergyModel::climb_power, &EnergyModel::reserve};

std::vector<double> figures_of(const VehicleModel& vehicle) {
  std::vector<double> figures{vehicle.hovers ? 1.0 : 0.0};
  for (const auto figure : kFigures) figures.push_back(vehicle.*figure);
  for (const auto figure : kEnergyFigures) figures.push_back(vehicle.energy.*figure);
  return figures;
}

VehicleModel vehicle_of(const std::vector<double>& figures) {
  VehicleModel vehicle;
  std::size_t at = 0;
  vehicle.hovers = figures[at++] != 0;
  for (const auto figure : kFigures) vehicle.*figure = figures[at++];
  for (const auto figure : kEnergyFigures) vehicle.energy.*figure = figures[at++];
  return vehicle;
}

}  // namespace

Rows offer_of(const Sweeper& sweeper) {
  return {{"start", "", {sweeper.start.x(), sweeper.start.y()}},
          {"sweep", "", {sweeper.altitude, sweeper.swath, sweeper.busy}},
          {"vehicle", "", figures_of(sweeper.vehicle)}};
}

Result<Sweeper, std::string> sweeper_of(const Rows& offer) {
  constexpr std::size_t kVehicle = 1 + kFigures.size() + kEnergyFigures.size();
  for (const auto& [name, numbers] :
       {std::pair("start", std::size_t{2}), std::pair("sweep", std::size_t{3}),
        std::pair("vehicle", kVehicle)}) {
    if (auto missing = missing_row(offer, name, numbers))
      return tl::unexpected<std::string>(*missing);
  }
  const auto& start = only_row(offer, "start")->numbers;
  const auto& sweep = only_row(offer, "sweep")->numbers;
  Sweeper sweeper{vehicle_of(only_row(offer, "vehicle")->numbers),
                  {start[0], start[1]},
                  sweep[0],
                  sweep[1],
                  sweep[2]};
  for (const auto& [name, figure] :
       {std::pair("altitude", sweeper.altitude), std::pair("swath", sweeper.swath)}) {
    if (auto problem = refiners::check_positive(figure, name))
      return tl::unexpected<std::string>(std::string(name) + ": " + problem->why);
  }
  if (!(sweeper.busy >= 0)) return tl::unexpected<std::string>("busy: a time is at least 0");
  if (auto problem = refiners::check_vehicle(sweeper.vehicle))
    return tl::unexpected<std::string>(problem->field + ": " + problem->why);
  return sweeper;
}

Row row_of(const std::string& name, const world::Polygon& polygon) {
  Row row{name, "", {}};
  for (const world::Vector2& corner : polygon)
    row.numbers.insert(row.numbers.end(), {corner.x(), corner.y()});
  return row;
}

world::Polygon polygon_of(const Row& row) {
  world::Polygon polygon;
  for (std::size_t i = 0; i + 1 < row.numbers.size(); i += 2)
    polygon.emplace_back(row.numbers[i], row.numbers[i + 1]);
  return polygon;
}

}  // namespace skein::interaction
