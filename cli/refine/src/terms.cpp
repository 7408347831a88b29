// SPDX-License-Identifier: Apache-2.0
#include "terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "skein/foundation/nearest.hpp"
#include "skein/world/environment_reader.hpp"
#include "skein/world/polygon_rings.hpp"
#include "skein/world/vehicle_model_reader.hpp"

namespace skein::refine_tool {
namespace {

using config::Range;
using config::Reader;
using world::Vector2;
using world::Vector3;

constexpr double kTurn = 2 * std::numbers::pi;
/// More corners than that are no outline of a field.
constexpr std::size_t kMostRingCorners = 1'000'000;
constexpr Range kLength{0, world::kFarthest, "m"};

std::vector<std::string> zone_names(const world::World& world) {
  std::vector<std::string> names;
  for (const world::Zone& zone : world.zones) names.push_back(zone.name);
  return names;
}

/// Half the width of what a sensor that looks down sees, per metre of altitude.
double half_width(const world::SensorModel& sensor) { return std::tan(sensor.aperture); }

bool looks_down(const world::SensorModel& sensor) {
  return sensor.gimballed || std::abs(sensor.boresight_pitch + std::numbers::pi / 2) < 0.05;
}

}  // namespace

double metres(const Reader& reader, double otherwise) { return reader.number(otherwise, kLength); }

double speed(const Reader& reader) { return reader.number(0, {-1000, 1000, "m/s"}); }

double angle(const Reader& reader, double otherwise) {
  return reader.number(otherwise, {-kTurn, kTurn, "rad"});
}

std::optional<double> optional_angle(const Reader& reader) {
  if (!reader.present()) return std::nullopt;
  return angle(reader);
}

std::vector<std::string> Terms::place_names() const {
  std::vector<std::string> names;
  for (const auto& [name, at] : world_.places) names.push_back(name);
  return names;
}

Vector2 Terms::lonlat(const Reader& reader) const {
  const std::vector<double> figures = reader.numbers(2, {-180, 180, "degrees"});
  if (figures.size() != 2) return Vector2::Zero();
  if (std::abs(figures[1]) > 90)
    reader.error("a latitude of " + std::to_string(figures[1]) + " degrees",
                 "[longitude, latitude]");
  world::GeodeticPoint point;
  point.longitude_degrees = figures[0];
  point.latitude_degrees = std::clamp(figures[1], -90.0, 90.0);
  point.altitude = world_.origin.altitude;
  return frame_.to_local(point).head<2>();
}

/// Of a place over the ground.
Vector2 Terms::point(const Reader& reader) const {
  const Reader on_earth = reader.optional("lonlat");
  if (on_earth.present()) {
    reader.keys({"lonlat", "height"});
    return lonlat(on_earth);
  }
  reader.keys({"at", "height"});
  const Reader at = reader.required("at");
  if (at.is_sequence()) return world::read_point_2d(at);
  return at.present() ? Vector2(place(at).head<2>()) : Vector2(Vector2::Zero());
}

Vector3 Terms::over_ground(const Reader& reader) const {
  const Vector2 point = this->point(reader);
  const double height = reader.required("height").number(0, {-1000, 20'000, "m"});
  return {point.x(), point.y(), world_.terrain.elevation(point.x(), point.y()) + height};
}

Vector3 Terms::place(const Reader& reader) const {
  if (reader.is_map()) return over_ground(reader);
  if (reader.is_sequence()) return world::read_point(reader);
  if (!reader.present()) return Vector3::Zero();
  const std::string name = reader.name_among(place_names(), "[x, y, z], or a place of the world");
  const auto found = world_.places.find(name);
  return found == world_.places.end() ? Vector3(Vector3::Zero()) : found->second;
}

std::optional<Vector3> Terms::optional_place(const Reader& reader) const {
  if (!reader.present()) return std::nullopt;
  return place(reader);
}

refiners::Way Terms::places(const Reader& reader) const {
  refiners::Way way;
  if (!reader.present()) return way;
  for (const Reader& item : world::items_of(reader)) way.push_back(place(item));
  return way;
}

world::Polygon Terms::area(const Reader& reader) const {
  if (!reader.present()) return {};
  if (!reader.is_scalar()) {
    const bool on_earth = reader.is_map();
    if (on_earth) reader.keys({"lonlat"});
    world::Polygon ring;
    for (const Reader& corner : world::items_of(on_earth ? reader.required("lonlat") : reader))
      ring.push_back(on_earth ? lonlat(corner) : world::read_point_2d(corner));
    return world::without_closing_corner(std::move(ring));
  }
  const std::string name =
      reader.name_among(zone_names(world_), "[[x, y], …], or a zone of the world");
  for (const world::Zone& zone : world_.zones)
    if (zone.name == name) return zone.polygon;
  return {};
}

/// The polygon of a file that is meant.
std::optional<geodata::Shape> Terms::in_file(const Reader& reader) const {
  reader.keys({"file", "name", "crs"});
  const Reader file = reader.required("file"), named = reader.optional("name");
  if (!file.present() || !references_.shapes_in_file) return std::nullopt;
  auto shapes =
      references_.shapes_in_file(file.text(), world_.origin, reader.optional("crs").text());
  if (!shapes) {
    file.error("the file cannot be read");
    diagnostics_.append(shapes.error());
    return std::nullopt;
  }
  if (!named.present()) {
    if (shapes->size() == 1) return std::move(shapes->front());
    reader.error(std::to_string(shapes->size()) + " polygons are in the file",
                 "name: which of them");
    return std::nullopt;
  }
  std::vector<std::string> names;
  for (const geodata::Shape& shape : *shapes) names.push_back(shape.name);
  const std::string name = named.name_among(names, "the name of a polygon in the file");
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return std::move((*shapes)[static_cast<std::size_t>(found - names.begin())]);
}

geodata::Shape Terms::shape(const Reader& reader) const {
  geodata::Shape shape;
  if (reader.is_map() && reader.optional("file").present())
    shape = in_file(reader).value_or(geodata::Shape());
  else
    shape.outer = area(reader);
  shape.outer = simplified(std::move(shape.outer), reader);
  note_beyond(reader.path(), shape.outer);
  for (world::Polygon& hole : shape.holes) hole = simplified(std::move(hole), reader);
  return shape;
}

world::Polygon Terms::ground(const Reader& reader) const {
  geodata::Shape whole = shape(reader);
  if (!whole.holes.empty())
    reader.error("the polygon has holes", "one without, since only coverage leaves them out");
  return std::move(whole.outer);
}

world::Polygon Terms::simplified(world::Polygon polygon, const Reader& reader) const {
  if (polygon.size() > kMostRingCorners) {
    reader.error(std::to_string(polygon.size()) + " corners",
                 "at most " + std::to_string(kMostRingCorners));
    return {};
  }
  const std::size_t given = polygon.size();
  auto simpler = world::simplified(polygon);
  if (!simpler) {
    reader.error(
        "it crosses itself however its " + std::to_string(given) + " corners are simplified",
        "a simple polygon");
    return {};
  }
  if (simpler->polygon.size() < given)
    notes_.push_back(fmt::format(
        "{}: {} corners were simplified to {}: no point of the border moves by more than {:.2f} m",
        reader.path(), given, simpler->polygon.size(), simpler->tolerance));
  return std::move(simpler->polygon);
}

/// What the terrain does not know is taken to be as high as at its border.
void Terms::note_beyond(const std::string& path, const world::Polygon& polygon) const {
  const world::TerrainSpec& known = world_.terrain.spec();
  double beyond = 0;
  for (const Vector2& corner : polygon)
    beyond = std::max({beyond, known.west - corner.x(), corner.x() - known.east,
                       known.south - corner.y(), corner.y() - known.north});
  if (beyond > 0)
    notes_.push_back(fmt::format(
        "{}: it reaches {:.0f} m beyond the ground that is known, which is taken to go on there as "
        "high as at its border",
        path, beyond));
}

std::vector<world::Volume> Terms::volumes(const Reader& reader) const {
  std::vector<world::Volume> volumes;
  if (!reader.present()) return volumes;
  for (const auto& [name, entry] : world::entries_of(reader)) {
    if (!entry.keys({"polygon", "floor", "ceiling", "from", "until"})) continue;
    world::Volume volume;
    volume.name = name;
    volume.polygon = area(entry.required("polygon"));
    volume.floor = entry.optional("floor").number(volume.floor, world::kCoordinate);
    volume.ceiling = entry.optional("ceiling").number(volume.ceiling, world::kCoordinate);
    volume.when.from = world::read_instant(entry.optional("from"));
    volume.when.until = world::read_instant(entry.optional("until"), MissionTime::max());
    if (volume.floor >= volume.ceiling) entry.error("the floor is not below the ceiling");
    if (volume.when.from >= volume.when.until) entry.error("it ends before it begins");
    volumes.push_back(std::move(volume));
  }
  return volumes;
}

world::VehicleModel Terms::vehicle(const Reader& reader) const {
  if (!reader.present()) return {};
  if (reader.is_map()) return world::read_vehicle_model(reader);
  auto model = references_.vehicle_in_file(reader.text());
  if (model) return std::move(*model);
  reader.error("the vehicle model cannot be read");
  diagnostics_.append(model.error());
  return {};
}

double Terms::swath(const Reader& reader, const world::VehicleModel& vehicle,
                    double altitude) const {
  const Reader given = reader.optional("swath"), device = reader.optional("device");
  if (given.present() == device.present()) {
    reader.error(given.present() ? "swath beside device" : "neither swath nor device",
                 "swath: METRES, or device: NAME of a sensor of the vehicle that looks down");
    return 0;
  }
  if (given.present()) return given.number(0, {-world::kFarthest, world::kFarthest, "m"});
  std::vector<std::string> devices;
  for (const world::SensorModel& sensor : vehicle.sensors) devices.push_back(sensor.device);
  const std::string name = device.name_among(devices, "a sensor of the vehicle");
  const world::SensorModel* sensor = world::find_sensor(vehicle, name);
  if (sensor == nullptr) return 0;
  if (!looks_down(*sensor)) device.error("'" + name + "' does not look down");
  if (altitude > sensor->range)
    device.error("'" + name + "' does not see the ground from that altitude",
                 "at most its range, " + std::to_string(static_cast<int>(sensor->range)) + " m");
  return 2 * altitude * half_width(*sensor);
}

}  // namespace skein::refine_tool
