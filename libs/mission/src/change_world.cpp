// SPDX-License-Identifier: Apache-2.0
// Changes of the world in words, and what makes no sense of them.
#include <algorithm>
#include <cmath>

#include "skein/mission/autonomy.hpp"
#include "skein/mission/home.hpp"

namespace skein::mission {

namespace {

using Problems = std::vector<std::string>;

void check_corners(const world::Polygon& corners, const std::string& what, Problems& out) {
  const bool finite = std::all_of(corners.begin(), corners.end(),
                                  [](const auto& corner) { return corner.allFinite(); });
  if (!finite) out.push_back("a corner of the " + what + " is not finite");
  if (corners.size() < 3) out.push_back("the " + what + " has fewer than three corners");
}

Problems problems(const world::Volume& volume) {
  Problems out;
  if (volume.name.empty()) out.emplace_back("the volume has no name");
  check_corners(volume.polygon, "volume", out);
  if (!(volume.floor < volume.ceiling)) {
    out.emplace_back("the volume's floor is not below its ceiling");
  }
  if (volume.when.until <= volume.when.from) {
    out.emplace_back("the volume is open again before it is closed");
  }
  return out;
}

Problems problems(const KnownPlace& place) {
  Problems out;
  if (place.name.empty()) out.emplace_back("the place has no name");
  if (means_home(place.name)) out.push_back("'" + place.name + "' is each UAV's own home");
  if (!place.at.allFinite()) out.emplace_back("where the place is is not finite");
  if (!std::isfinite(place.radius) || place.radius < 0) {
    out.emplace_back("the radius of the place must be finite and not negative");
  }
  return out;
}

Problems problems(const KnownGround& ground) {
  Problems out;
  check_corners(ground.area, "ground", out);
  if (ground.risk && !(*ground.risk >= 0 && *ground.risk <= 1)) {
    out.emplace_back("the risk of the ground must be from 0 to 1");
  }
  if (!ground.risk && !ground.mapped && !ground.cells) {
    out.emplace_back("nothing is said of the ground: risk, mapped or cells");
  }
  return out;
}

}  // namespace

std::string to_text(const ChangeWorld& change) {
  if (change.place) return "place '" + change.place->name + "' known";
  if (change.ground) return "ground of '" + change.ground->name + "' known";
  return "volume '" + change.volume.name + (change.remove ? "' opened" : "' closed");
}

std::vector<std::string> problems_of(const ChangeWorld& change) {
  if (change.place) return problems(*change.place);
  if (change.ground) return problems(*change.ground);
  if (!change.remove) return problems(change.volume);
  return change.volume.name.empty() ? Problems{"the volume has no name"} : Problems{};
}

}  // namespace skein::mission
