// SPDX-License-Identifier: Apache-2.0
// What a ground station's file says: a mission, fences, rally points, areas and ways, as it says
// it, on Earth.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/foundation/diagnostics.hpp"

namespace skein::mission_files {

/// Where in the file something stands.
struct Mark {
  int line = 0;      ///< from 1
  std::string path;  ///< "mission.items[3]", "Placemark 'tower'"
};

enum class HeightOver { kSeaLevel, kHome, kGround };

struct Height {
  double metres = 0;
  HeightOver over = HeightOver::kGround;
  bool operator==(const Height&) const = default;
};

/// WGS 84.
struct LatLon {
  double latitude = 0;   ///< [degrees], -90 to 90
  double longitude = 0;  ///< [degrees], -180 to 180
  bool operator==(const LatLon&) const = default;
};

struct Position {
  LatLon at;
  std::optional<Height> height;  ///< absent: the file does not say it
  bool operator==(const Position&) const = default;
};

struct TakeOff {
  Height to;
};
struct FlyTo {
  Position to;
  double hold = 0;     ///< there [s], >= 0
  bool stays = false;  ///< for ever: what comes after it is never reached
};
struct Land {
  std::optional<LatLon> at;  ///< absent: where it is
};
struct ReturnHome {};  ///< and land
struct Delay {
  double seconds = 0;  ///< > 0
};
struct ChangeSpeed {
  double speed = 0;  ///< [m/s], > 0
};
struct TakePictures {
  int count = 0;  ///< 0: until StopPictures, or the end
};
struct StopPictures {};

using Step =
    std::variant<TakeOff, FlyTo, Land, ReturnHome, Delay, ChangeSpeed, TakePictures, StopPictures>;

/// One thing to do after another.
struct Item {
  Step step;
  Mark mark;
};

struct Home {
  LatLon at;
  std::optional<double> over_sea;  ///< [m]
  Mark mark;
};

struct Circle {
  LatLon centre;
  double radius = 0;  ///< [m], > 0
};

/// Of which flight keeps inside, or outside.
struct Fence {
  std::variant<std::vector<LatLon>, Circle> shape;  ///< a ring without its closing corner
  bool inclusion = false;
  Mark mark;
};

/// A polygon that somebody drew.
struct Area {
  std::string name;                  ///< may be empty
  std::vector<std::string> folders;  ///< that it is in, outermost first
  std::vector<LatLon> ring;          ///< without its closing corner
  std::optional<Height> top;         ///< of a body from the ground up
  Mark mark;
};

/// A line that somebody drew.
struct Way {
  std::string name;  ///< may be empty
  std::vector<Position> points;
  Mark mark;
};

struct Place {
  std::string name;  ///< may be empty
  Position position;
  Mark mark;
};

struct Contents {
  std::optional<Home> home;
  std::vector<Item> items;
  std::vector<Fence> fences;
  std::vector<Area> areas;
  std::vector<Way> ways;
  std::vector<Place> places;
  /// What is in the file and is not in the above, in its order: nothing is left out in silence.
  Diagnostics left_out;
};

}  // namespace skein::mission_files
