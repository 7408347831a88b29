// SPDX-License-Identifier: Apache-2.0
#include "skein/import_tool/import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <ostream>

#include "airspace.hpp"
#include "flight.hpp"
#include "scenario_text.hpp"
#include "site.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/mission_files/read.hpp"
#include "skein/scenario/scenario.hpp"
#include "skein/workers/shipped.hpp"

namespace skein::import_tool {
namespace {

namespace fs = std::filesystem;
using mission_files::Contents;
using mission_files::FlyTo;
using mission_files::Home;
using mission_files::Item;
using mission_files::LatLon;

/// Of level ground around what is imported [m].
constexpr double kMargin = 500;
/// No mission is farther across [m].
constexpr double kFarthest = 100'000;
/// To fly to: scenarios have no more room.
constexpr std::size_t kMostPoints = 50'000;
/// Beyond the ground, of the air outside of an inclusion [m].
constexpr double kBeyond = 1000;

tl::unexpected<Diagnostics> refuse(std::string option, std::string why, std::string expected) {
  Diagnostics problems;
  problems.add({"", 0, 0, std::move(option), std::move(why), std::move(expected), ""});
  return tl::make_unexpected(std::move(problems));
}

/// Every corner and point of a file.
std::vector<LatLon> points_of(const Contents& contents) {
  std::vector<LatLon> points;
  for (const Item& item : contents.items) {
    if (const auto* fly = std::get_if<FlyTo>(&item.step)) points.push_back(fly->to.at);
    if (const auto* land = std::get_if<mission_files::Land>(&item.step); land && land->at)
      points.push_back(*land->at);
  }
  for (const auto& way : contents.ways)
    for (const auto& point : way.points) points.push_back(point.at);
  for (const auto& place : contents.places) points.push_back(place.position.at);
  for (const auto& area : contents.areas)
    points.insert(points.end(), area.ring.begin(), area.ring.end());
  for (const auto& fence : contents.fences) {
    if (const auto* circle = std::get_if<mission_files::Circle>(&fence.shape))
      points.push_back(circle->centre);
    else
      for (const LatLon& corner : std::get<std::vector<LatLon>>(fence.shape))
        points.push_back(corner);
  }
  return points;
}

/// As asked for, as the file says it, or else its first point.
std::optional<Home> home_of(const Contents& contents, const ImportOptions& options, Log& log) {
  if (options.home.size() == 2) return Home{{options.home[0], options.home[1]}, {}, {}};
  if (contents.home) return contents.home;
  const auto points = points_of(contents);
  if (points.empty()) return std::nullopt;
  log.say("the file says no home: its first point is taken for it");
  return Home{points.front(), {}, {}};
}

Ground level_ground(const Contents& contents, const Home& home, const ImportOptions& options) {
  Ground ground;
  ground.origin = {
      home.at.latitude, home.at.longitude,
      std::clamp(home.over_sea.value_or(0) + options.geoid.value_or(0), -1000.0, 100'000.0)};
  const geodesy::GeodeticFrame frame(ground.origin);
  const auto include = [&](const LatLon& at, double around) {
    const auto there = frame.to_local({at.latitude, at.longitude, ground.origin.altitude});
    ground.sides.include({there.x() - around, there.y() - around});
    ground.sides.include({there.x() + around, there.y() + around});
  };
  for (const LatLon& point : points_of(contents)) include(point, kMargin);
  for (const auto& fence : contents.fences)
    if (const auto* circle = std::get_if<mission_files::Circle>(&fence.shape))
      include(circle->centre, circle->radius + kMargin);
  include(home.at, kMargin);
  Sides& sides = ground.sides;
  sides = {std::floor(sides.west), std::floor(sides.south), std::ceil(sides.east),
           std::ceil(sides.north)};
  ground.cell =
      std::max(20.0, std::ceil(std::max(sides.east - sides.west, sides.north - sides.south) / 500));
  return ground;
}

std::string beside(const std::string& file, const std::string& scenario_file) {
  const fs::path folder = fs::absolute(scenario_file).parent_path();
  return fs::absolute(file)
      .lexically_normal()
      .lexically_proximate(folder.lexically_normal())
      .string();
}

class Import {
 public:
  Import(const Contents& contents, const ImportOptions& options, std::string scenario_file)
      : contents_(contents),
        options_(options),
        scenario_file_(std::move(scenario_file)),
        log_(options.file) {}

  Result<Imported, Diagnostics> run() {
    const auto home = home_of(contents_, options_, log_);
    if (!home)
      return refuse("--home", "nothing in the file says where on Earth it is",
                    "--home LATITUDE LONGITUDE");
    parts_.ground = level_ground(contents_, *home, options_);
    if (const Sides& sides = parts_.ground.sides;
        std::max(sides.east - sides.west, sides.north - sides.south) > kFarthest)
      return refuse(
          "",
          fmt::format("its points are {:.0f} km apart",
                      std::hypot(sides.east - sides.west, sides.north - sides.south) / 1000),
          "at most 100 km, home with them");
    if (!options_.world.empty()) parts_.ground.world = beside(options_.world, scenario_file_);
    parts_.uav = options_.uav;
    parts_.model = beside(options_.model, scenario_file_);
    const auto empty = scenario::read_scenario_text(
        empty_scenario_text(parts_.ground, parts_.uav, parts_.model), scenario_file_);
    if (!empty) return tl::make_unexpected(empty.error());
    return convert(*empty, *home);
  }

 private:
  Result<Imported, Diagnostics> convert(const scenario::Scenario& empty, const Home& home) {
    const scenario::WorldSpec& world = empty.world;
    const Site site(world.origin, world.terrain, home.at, home.over_sea, options_.geoid);
    const Sides ground{world.terrain.west - kBeyond, world.terrain.south - kBeyond,
                       world.terrain.east + kBeyond, world.terrain.north + kBeyond};
    if (const auto& at = site.home(); !site.terrain().contains(at.x(), at.y()))
      log_.wrong(home.mark,
                 fmt::format("home is at x {:.0f}, y {:.0f} m, outside of the world's ground",
                             at.x(), at.y()),
                 "a world around the mission, or --home");
    reserve_names(world);
    parts_.airspace = airspace_of(contents_, options_.closed, site, ground, names_, log_);
    take_places(site);
    auto closed = parts_.airspace.closed;
    closed.insert(closed.end(), world.volumes.begin(), world.volumes.end());
    const FlightOptions how{options_.camera, options_.altitude};
    const std::vector<Item> items = all_items();
    if (items.size() > kMostPoints)
      return refuse("", std::to_string(items.size()) + " points to fly to",
                    "at most " + std::to_string(kMostPoints));
    parts_.flight = flight_of(items, how, site, empty.uavs.front().model, closed, log_);
    parts_.start = site.home();
    return finish();
  }

  void reserve_names(const scenario::WorldSpec& world) {
    for (const auto& zone : world.zones) names_.reserve(zone.name);
    for (const auto& volume : world.volumes) names_.reserve(volume.name);
    for (const auto& [name, at] : world.places) names_.reserve(name);
    for (const auto& object : world.objects) names_.reserve(object.name);
  }

  void take_places(const Site& site) {
    for (const auto& place : contents_.places) {
      const auto height = place.position.height.value_or(
          mission_files::Height{0, mission_files::HeightOver::kGround});
      const auto at = site.at(place.position.at, height);
      if (at)
        parts_.places.emplace(names_.make(place.name, "place"), *at);
      else
        log_.wrong(place.mark, "its height counts from sea level",
                   "--geoid METRES, how high the sea is over the ellipsoid there");
    }
  }

  /// The mission, then the ways that somebody drew, one after another, and home.
  std::vector<Item> all_items() const {
    std::vector<Item> items = contents_.items;
    for (const auto& way : contents_.ways)
      for (const auto& point : way.points) items.push_back({FlyTo{point}, way.mark});
    if (!contents_.ways.empty())
      items.push_back({mission_files::ReturnHome{}, contents_.ways.back().mark});
    return items;
  }

  Result<Imported, Diagnostics> finish() {
    if (!log_.errors().empty()) return tl::make_unexpected(log_.errors());
    Imported made;
    made.left_out = contents_.left_out;
    made.left_out.append(log_.left_out());
    made.said = log_.said();
    parts_.source = fs::path(options_.file).filename().string();
    parts_.name =
        plain_name(options_.name.empty() ? fs::path(options_.file).stem().string() : options_.name);
    if (parts_.name.empty()) parts_.name = "imported";
    made.yaml = scenario_text(parts_, made.left_out);
    const auto checked = scenario::read_scenario_text(made.yaml, scenario_file_);
    if (!checked) return tl::make_unexpected(checked.error());
    return made;
  }

  const Contents& contents_;
  const ImportOptions& options_;
  std::string scenario_file_;
  Log log_;
  Names names_;
  Parts parts_;
};

/// As somebody asks for it who has no model.
std::string default_model() {
  const std::string shipped = workers::shipped_scenarios();
  return shipped.empty() ? "" : shipped + "/comets/models/marvin.yaml";
}

void tell(const Imported& made, std::ostream& err) {
  for (const std::string& one : made.said) err << one << '\n';
  for (const Diagnostic& one : made.left_out.all()) err << "left out: " << to_text(one) << '\n';
}

int write(const ImportOptions& options, const Imported& made, std::ostream& out,
          std::ostream& err) {
  if (options.out.empty()) {
    out << made.yaml;
    return kExitOk;
  }
  std::ofstream file(options.out, std::ios::binary | std::ios::trunc);
  file << made.yaml;
  file.close();
  if (!file) {
    err << options.out << ": cannot be written\n";
    return kExitSystem;
  }
  out << options.out << '\n';
  return kExitOk;
}

}  // namespace

Result<Imported, Diagnostics> to_scenario(const Contents& contents, const ImportOptions& options,
                                          const std::string& scenario_file) {
  return Import(contents, options, scenario_file).run();
}

int import_mission(const ImportOptions& given, std::ostream& out, std::ostream& err) {
  ImportOptions options = given;
  if (options.model.empty()) options.model = default_model();
  const auto contents = mission_files::read_file(options.file);
  if (!contents) {
    err << to_text(contents.error());
    return kExitBadInput;
  }
  if (options.model.empty()) {
    err << "no models of vehicles found; expected: --model FILE\n";
    return kExitBadInput;
  }
  const auto made =
      to_scenario(*contents, options, options.out.empty() ? "imported.yaml" : options.out);
  if (!made) {
    err << to_text(contents->left_out) << to_text(made.error());
    return kExitBadInput;
  }
  if (!made->left_out.empty() && !options.leave_out) {
    err << to_text(made->left_out)
        << "what Skein has no counterpart of; --leave-out imports the rest\n";
    return kExitBadInput;
  }
  tell(*made, err);
  return write(options, *made, out, err);
}

}  // namespace skein::import_tool
