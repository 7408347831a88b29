// SPDX-License-Identifier: Apache-2.0
// Areas and fences of a file as zones and closed air.
#pragma once

#include <string>
#include <vector>

#include "log.hpp"
#include "names.hpp"
#include "site.hpp"
#include "skein/mission_files/contents.hpp"
#include "skein/world/volume.hpp"
#include "skein/world/zone.hpp"

namespace skein::import_tool {

struct Airspace {
  std::vector<world::Zone> zones;
  std::vector<world::Volume> closed;
};

/// `closed`: names, besides the usual ones ("fence", "no-fly", …), of areas that are closed air;
/// `sides`: how far the air outside of an inclusion is closed.
Airspace airspace_of(const mission_files::Contents& contents,
                     const std::vector<std::string>& closed, const Site& site, const Sides& sides,
                     Names& names, Log& log);

/// What of a rectangle is not in a simple polygon inside of it: the part south of it and the part
/// north of it, simple both, without a point of its inside.
std::vector<world::Polygon> outside_of(world::Polygon polygon, const Sides& sides);

/// Corners on a circle around it (`around`), or on the circle.
world::Polygon circle_polygon(const world::Vector2& centre, double radius, bool around);

}  // namespace skein::import_tool
