// SPDX-License-Identifier: Apache-2.0
// The terms that queries of all services are made of: places, areas, vehicles, volumes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "query_reader.hpp"
#include "skein/geodesy/geodetic_frame.hpp"
#include "skein/refiners/flight.hpp"

namespace skein::refine_tool {

/// Reads the terms of one query. What is wrong goes to the readers' diagnostics, and something
/// harmless is given in its place.
class Terms {
 public:
  /// All must outlive it. `notes`: what is done to make an area of what is written.
  Terms(const world::World& world, const References& references, Diagnostics& diagnostics,
        std::vector<std::string>& notes)
      : world_(world),
        references_(references),
        diagnostics_(diagnostics),
        notes_(notes),
        frame_(world.origin) {}

  /// [x, y, z], the name of a place, {at: [x, y] or a name, height: above the ground}, or {lonlat:
  /// [longitude, latitude], height}.
  world::Vector3 place(const config::Reader& reader) const;
  std::optional<world::Vector3> optional_place(const config::Reader& reader) const;
  refiners::Way places(const config::Reader& reader) const;
  /// [[x, y], …], {lonlat: [[longitude, latitude], …]}, or the name of a zone; the last corner may
  /// be the first again.
  world::Polygon area(const config::Reader& reader) const;
  /// The same of what is to be swept or watched, or {file, name, crs}: a polygon of a file (its
  /// only one, or that of this name). More corners than can be worked with are simplified, which is
  /// noted. Holes in it are errors.
  world::Polygon ground(const config::Reader& reader) const;
  /// The same with holes.
  geodata::Shape shape(const config::Reader& reader) const;
  /// {NAME: {polygon, floor, ceiling, from, until}}.
  std::vector<world::Volume> volumes(const config::Reader& reader) const;
  /// The name of a model file, or a model written inside.
  world::VehicleModel vehicle(const config::Reader& reader) const;
  /// `swath` as a number, or that of the `device` from this altitude; of a member of the query.
  double swath(const config::Reader& reader, const world::VehicleModel& vehicle,
               double altitude) const;

  const world::World& world() const { return world_; }

 private:
  world::Vector3 over_ground(const config::Reader& reader) const;
  std::optional<geodata::Shape> in_file(const config::Reader& reader) const;
  world::Polygon simplified(world::Polygon polygon, const config::Reader& reader) const;
  void note_beyond(const std::string& path, const world::Polygon& polygon) const;
  world::Vector2 point(const config::Reader& reader) const;
  world::Vector2 lonlat(const config::Reader& reader) const;
  std::vector<std::string> place_names() const;

  const world::World& world_;
  const References& references_;
  Diagnostics& diagnostics_;
  std::vector<std::string>& notes_;
  geodesy::GeodeticFrame frame_;
};

// Ranges of figures, all services alike. Zero and negative speeds are left to the refiners, which
// name the field too, wherever a query comes from.
double metres(const config::Reader& reader, double otherwise = 0);
double speed(const config::Reader& reader);
std::optional<double> optional_angle(const config::Reader& reader);
double angle(const config::Reader& reader, double otherwise = 0);

}  // namespace skein::refine_tool
