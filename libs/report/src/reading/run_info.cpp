// SPDX-License-Identifier: Apache-2.0
#include "skein/report/run_info.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "reading/field_reader.hpp"

namespace skein::report {

namespace {

using InfoJson = nlohmann::ordered_json;

constexpr std::array<std::string_view, 2> kRuntimes{"dds", "virtual"};
constexpr std::size_t kMostTerrainCells = 4'000'000;

double finite(double value) { return std::isfinite(value) ? value : 0.0; }

InfoJson to_json_value(const TerrainGrid& t) {
  InfoJson values = InfoJson::array();
  // Centimetres are finer than any map shows, and keep the file small.
  for (const double v : t.values) values.push_back(std::round(finite(v) * 100.0) / 100.0);
  return {{"west", finite(t.west)}, {"south", finite(t.south)}, {"cell", finite(t.cell)},
          {"width", t.width},       {"height", t.height},       {"values", std::move(values)}};
}

InfoJson to_json_value(const Zone& zone) {
  InfoJson points = InfoJson::array();
  for (const GroundPoint& p : zone.polygon) {
    points.push_back(InfoJson::array({finite(p.x), finite(p.y)}));
  }
  return {{"name", zone.name}, {"polygon", std::move(points)}};
}

InfoJson to_json_value(const ClosedAir& air) {
  InfoJson json = to_json_value(Zone{air.name, air.polygon});
  json["from"] = finite(air.from);
  if (air.until) json["until"] = finite(*air.until);
  return json;
}

InfoJson to_json_value(const Place& place) {
  const Position& p = place.position;
  return {{"name", place.name},
          {"position", InfoJson::array({finite(p.x), finite(p.y), finite(p.z)})}};
}

InfoJson to_json_value(const UavInfo& uav) {
  return {{"name", uav.name}, {"model", uav.model}, {"degree", uav.degree}};
}

template <class T>
InfoJson to_json_list(const std::vector<T>& items) {
  InfoJson list = InfoJson::array();
  for (const T& item : items) list.push_back(to_json_value(item));
  return list;
}

// Gives each object of the list at `key` to `read`; another shape is a fault.
template <class Read>
void read_list(const nlohmann::json& document, const char* key, const Diagnostic& where,
               Diagnostics& faults, Read read) {
  const auto list = document.find(key);
  if (list == document.end()) return;
  for (std::size_t i = 0; list->is_array() && i < list->size(); ++i) {
    Diagnostic at = where;
    at.path = std::string(key) + "[" + std::to_string(i) + "]";
    if ((*list)[i].is_object()) {
      FieldReader fields((*list)[i], at, faults);
      read(fields, (*list)[i], at);
    } else {
      at.message = "not an object";
      faults.add(at);
    }
  }
  if (!list->is_array()) {
    Diagnostic at = where;
    at.path = key;
    at.message = "not a list";
    faults.add(at);
  }
}

bool is_coordinate(const nlohmann::json& v) {
  return v.is_number() && std::abs(v.get<double>()) <= kLargestNumber;
}

std::vector<GroundPoint> read_polygon(const nlohmann::json& zone, Diagnostic at,
                                      Diagnostics& faults) {
  std::vector<GroundPoint> polygon;
  at.path += ".polygon";
  at.message = "not a polygon";
  at.expected = "a list of [x, y] in metres";
  const auto points = zone.find("polygon");
  if (points == zone.end() || !points->is_array()) {
    faults.add(at);
    return polygon;
  }
  for (const nlohmann::json& p : *points) {
    if (p.is_array() && p.size() >= 2 && is_coordinate(p[0]) && is_coordinate(p[1])) {
      polygon.push_back({p[0].get<double>(), p[1].get<double>()});
    } else {
      faults.add(at);
      return polygon;
    }
  }
  return polygon;
}

std::optional<Extents> read_extents(const nlohmann::json& document, Diagnostic where,
                                    Diagnostics& faults) {
  const auto it = document.find("extents");
  if (it == document.end() || !it->is_object()) return std::nullopt;
  where.path = "extents";
  FieldReader f(*it, where, faults);
  return Extents{f.number("west"), f.number("south"), f.number("east"), f.number("north")};
}

std::optional<Origin> read_origin(const nlohmann::json& document, Diagnostic where,
                                  Diagnostics& faults) {
  const auto it = document.find("origin");
  if (it == document.end() || !it->is_object()) return std::nullopt;
  where.path = "origin";
  FieldReader f(*it, where, faults);
  const Origin origin{f.number("latitude"), f.number("longitude"), f.number("altitude")};
  if (std::abs(origin.latitude) <= 90 && std::abs(origin.longitude) <= 180) return origin;
  where.message = "not on Earth";
  where.expected = "latitude and longitude in degrees";
  faults.add(where);
  return std::nullopt;
}

void read_air(const nlohmann::json& document, const Diagnostic& where, Diagnostics& faults,
              RunInfo& info) {
  read_list(document, "air", where, faults,
            [&](FieldReader& f, const nlohmann::json& air, const Diagnostic& at) {
              ClosedAir one{f.name("name"), read_polygon(air, at, faults), f.number("from"), {}};
              if (air.contains("until")) one.until = f.number("until");
              info.air.push_back(std::move(one));
            });
}

std::optional<TerrainGrid> read_terrain(const nlohmann::json& document, Diagnostic where,
                                        Diagnostics& faults) {
  const auto it = document.find("terrain");
  if (it == document.end() || !it->is_object()) return std::nullopt;
  where.path = "terrain";
  const std::size_t faults_before = faults.size();
  FieldReader f(*it, where, faults);
  TerrainGrid t;
  t.west = f.number("west");
  t.south = f.number("south");
  t.cell = f.number("cell");
  const std::int64_t width = f.integer("width"), height = f.integer("height");
  const auto values = it->find("values");
  if (faults.size() > faults_before) return std::nullopt;
  const bool sized = t.cell > 0.0 && width > 0 && height > 0 &&
                     width <= std::int64_t{kMostTerrainCells} / height && values != it->end() &&
                     values->is_array() &&
                     values->size() == static_cast<std::size_t>(width * height) &&
                     std::all_of(values->begin(), values->end(), is_coordinate);
  if (!sized) {
    where.message = "not a grid";
    where.expected = "cell > 0 and width × height values, at most four million";
    faults.add(where);
    return std::nullopt;
  }
  t.width = static_cast<std::size_t>(width);
  t.height = static_cast<std::size_t>(height);
  t.values = values->get<std::vector<double>>();
  return t;
}

void read_head(FieldReader& f, RunInfo& info) {
  info.scenario = f.text("scenario");
  info.epoch = f.optional_text("epoch");
  info.runtime = static_cast<RuntimeKind>(f.one_of("runtime", f.text("runtime"), kRuntimes));
  info.rate = f.number("rate");
  info.seed = f.unsigned_integer("seed");
  info.wall_seconds = f.number("wall_seconds");
  info.version = f.optional_text("version");
}

void read_lists(const nlohmann::json& document, const Diagnostic& where, Diagnostics& faults,
                RunInfo& info) {
  read_list(document, "zones", where, faults,
            [&](FieldReader& f, const nlohmann::json& zone, const Diagnostic& at) {
              info.zones.push_back({f.name("name"), read_polygon(zone, at, faults)});
            });
  read_list(document, "places", where, faults,
            [&](FieldReader& f, const nlohmann::json&, const Diagnostic&) {
              info.places.push_back({f.name("name"), f.position("position")});
            });
  read_list(document, "uavs", where, faults,
            [&](FieldReader& f, const nlohmann::json&, const Diagnostic&) {
              info.uavs.push_back({f.name("name"), f.optional_text("model"),
                                   static_cast<int>(f.number("degree", 100.0))});
            });
}

}  // namespace

std::string to_json(const RunInfo& info) {
  InfoJson j;
  j["scenario"] = info.scenario;
  j["epoch"] = info.epoch;
  j["runtime"] = kRuntimes[static_cast<std::size_t>(info.runtime)];
  j["rate"] = finite(info.rate);
  j["seed"] = info.seed;
  j["wall_seconds"] = finite(info.wall_seconds);
  j["version"] = info.version;
  if (info.extents) {
    j["extents"] = {{"west", finite(info.extents->west)},
                    {"south", finite(info.extents->south)},
                    {"east", finite(info.extents->east)},
                    {"north", finite(info.extents->north)}};
  }
  if (info.origin) {
    j["origin"] = {{"latitude", finite(info.origin->latitude)},
                   {"longitude", finite(info.origin->longitude)},
                   {"altitude", finite(info.origin->altitude)}};
  }
  j["zones"] = to_json_list(info.zones);
  if (!info.air.empty()) j["air"] = to_json_list(info.air);
  j["places"] = to_json_list(info.places);
  j["uavs"] = to_json_list(info.uavs);
  if (info.terrain) j["terrain"] = to_json_value(*info.terrain);
  return j.dump(1, ' ', false, InfoJson::error_handler_t::replace) + "\n";
}

Result<RunInfo, Diagnostics> run_info_from_json(std::string_view text, std::string_view name) {
  Diagnostics faults;
  Diagnostic where{std::string(name), 0, 0, "", "", "", ""};
  const std::optional<nlohmann::json> document = parse_json(text, where, faults);
  if (!document) return tl::unexpected<Diagnostics>(std::move(faults));
  if (!document->is_object()) {
    where.message = "not a JSON object";
    faults.add(where);
    return tl::unexpected<Diagnostics>(std::move(faults));
  }
  RunInfo info;
  FieldReader fields(*document, where, faults);
  read_head(fields, info);
  info.origin = read_origin(*document, where, faults);
  info.extents = read_extents(*document, where, faults);
  info.terrain = read_terrain(*document, where, faults);
  read_lists(*document, where, faults, info);
  read_air(*document, where, faults, info);
  if (!faults.empty()) return tl::unexpected<Diagnostics>(std::move(faults));
  return info;
}

}  // namespace skein::report
