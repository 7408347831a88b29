// SPDX-License-Identifier: Apache-2.0
#include "map_features.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace skein::foxglove {

namespace {

using Json = nlohmann::ordered_json;

/// A tenth of a millimetre is finer than any map: a fraction of a degree with nine decimals.
double rounded(double degrees) { return std::round(degrees * 1e9) / 1e9; }

Json point(const Frame& frame, double x, double y, double z) {
  const world::GeodeticPoint at = frame.to_geodetic({x, y, z});
  return {rounded(at.longitude_degrees), rounded(at.latitude_degrees),
          std::round(at.altitude * 1000) / 1000};
}

Json ring(const Frame& frame, const std::vector<report::GroundPoint>& polygon) {
  Json corners = Json::array();
  for (const report::GroundPoint& one : polygon) corners.push_back(point(frame, one.x, one.y, 0));
  if (!polygon.empty()) corners.push_back(corners.front());
  return Json::array({corners});
}

Json feature(const std::string& name, const char* kind, Json coordinates, Json style) {
  return {{"type", "Feature"},
          {"properties", {{"name", name}, {"style", std::move(style)}}},
          {"geometry", {{"type", kind}, {"coordinates", std::move(coordinates)}}}};
}

std::string collection(Json features) {
  const Json all{{"type", "FeatureCollection"}, {"features", std::move(features)}};
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::array<double, 3> colour_of(std::size_t uav) {
  static constexpr std::array<std::array<double, 3>, 7> kAll{{{0.00, 0.45, 0.70},
                                                              {0.90, 0.62, 0.00},
                                                              {0.00, 0.62, 0.45},
                                                              {0.80, 0.47, 0.65},
                                                              {0.34, 0.71, 0.91},
                                                              {0.94, 0.89, 0.26},
                                                              {0.42, 0.42, 0.42}}};
  return kAll.at(uav % kAll.size());
}

std::string html_colour(const std::array<double, 3>& colour) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text = "#";
  for (const double part : colour) {
    const auto byte = static_cast<std::size_t>(std::lround(std::clamp(part, 0.0, 1.0) * 255));
    text += kDigits[byte / 16];
    text += kDigits[byte % 16];
  }
  return text;
}

std::string zones_geojson(const report::RunInfo& info, const Frame& frame) {
  Json features = Json::array();
  for (const report::Zone& zone : info.zones)
    features.push_back(feature(zone.name, "Polygon", ring(frame, zone.polygon),
                               {{"color", "#009e73"}, {"weight", 2}, {"fillOpacity", 0.1}}));
  for (const report::Place& place : info.places) {
    const report::Position& at = place.position;
    features.push_back(feature(place.name, "Point", point(frame, at.x, at.y, at.z),
                               {{"color", "#444444"}, {"weight", 2}}));
  }
  return collection(std::move(features));
}

std::string air_geojson(const report::RunInfo& info, MissionTime at, const Frame& frame) {
  Json features = Json::array();
  const double now = at.to_seconds();
  for (const report::ClosedAir& air : info.air) {
    if (now < air.from || (air.until && now >= *air.until)) continue;
    features.push_back(
        feature(air.name, "Polygon", ring(frame, air.polygon),
                {{"color", "#d55e00"}, {"weight", 2}, {"dashArray", "6 4"}, {"fillOpacity", 0.2}}));
  }
  return collection(std::move(features));
}

std::string ways_geojson(const std::map<std::string, std::vector<double>>& ways,
                         const std::string& colour, const Frame& frame) {
  Json features = Json::array();
  for (const auto& [name, way] : ways) {
    Json line = Json::array();
    for (std::size_t i = 0; i + 2 < way.size(); i += 3)
      line.push_back(point(frame, way[i], way[i + 1], way[i + 2]));
    if (line.size() < 2) continue;
    features.push_back(feature(name, "LineString", std::move(line),
                               {{"color", colour}, {"weight", 2}, {"dashArray", "4 4"}}));
  }
  return collection(std::move(features));
}

std::string alarms_geojson(const std::map<std::int64_t, journal::Record>& alarms,
                           const Frame& frame) {
  Json features = Json::array();
  for (const auto& [id, alarm] : alarms) {
    const std::vector<double> at = alarm.numbers("position");
    if (at.size() != 3) continue;
    const std::string name = "alarm " + std::to_string(id) + " " +
                             std::string(alarm.text("state")) + ", belief " +
                             std::to_string(static_cast<int>(alarm.number("belief") * 100)) + " %";
    features.push_back(feature(name, "Point", point(frame, at[0], at[1], at[2]),
                               {{"color", "#c1272d"}, {"weight", 4}}));
  }
  return collection(std::move(features));
}

}  // namespace skein::foxglove
