// SPDX-License-Identifier: Apache-2.0
#include "flyable/again.hpp"

#include <algorithm>
#include <cmath>

#include "flyable/search.hpp"

namespace skein::refiners {
namespace {

using world::Vector2;
using world::Vector3;

/// Places at most; more cost more than they gain.
constexpr double kMostPlaces = 48;
/// Two chords whose lengths differ by less are of one arc.
constexpr double kSameChord = 0.01;
constexpr int kRounds = 2;
constexpr double kWorthWhile = 0.998;
/// Of a leg's rise: what two slopes that are as steep as can be flown miss when they become one.
constexpr double kEased = 1e-8;

double heading_of(const Vector2& leg) { return std::atan2(leg.y(), leg.x()); }

/// The places of a way at which it is known where it heads: on straight legs, and in the middle of
/// arcs.
class Places {
 public:
  Places(const Way& way, double spacing) : spacing_(spacing) {
    for (std::size_t i = 1; i < way.size(); ++i) {
      const Vector3 leg = way[i] - way[i - 1];
      const double length = leg.head<2>().norm();
      if (length < 1e-9) continue;
      const double heading = heading_of(leg.head<2>());
      if (i == 1) add(way[0], heading, true);
      const double parts = std::ceil(length / spacing);
      for (double k = 1; k < parts; ++k) add(way[i - 1] + k / parts * leg, heading, false);
      if (i + 1 == way.size())
        add(way[i], heading, true);
      else
        add_corner(leg.head<2>(), way[i], (way[i + 1] - way[i]).head<2>());
    }
  }
  std::vector<StationLayer> layers;

 private:
  void add_corner(const Vector2& in, const Vector3& at, const Vector2& out) {
    const double turn = world::wrapped(heading_of(out) - heading_of(in));
    const bool of_arc = std::abs(in.norm() - out.norm()) < kSameChord * in.norm();
    if (std::abs(turn) < 1e-6 || of_arc) add(at, heading_of(in) + turn / 2, false);
  }
  void add(const Vector3& at, double heading, bool end) {
    const bool near = !layers.empty() && (at.head<2>() - last_).norm() < spacing_ / 2;
    if (near && !end) return;
    last_ = at.head<2>();
    layers.push_back({{Station{{last_, heading}, at.z()}}, layers.size()});
  }

  double spacing_;
  Vector2 last_ = Vector2::Zero();
};

}  // namespace

Way flown_again(const Way& way, FlyableLegs& legs, double radius, const EndHeadings& headings) {
  Way best = way;
  for (int round = 0; round < kRounds; ++round) {
    const double length = level_length(best);
    Places places(best, std::max(radius, length / kMostPlaces));
    if (places.layers.size() < 2) break;
    if (headings.from) places.layers.front().stations[0].pose.heading = *headings.from;
    if (headings.to) places.layers.back().stations[0].pose.heading = *headings.to;
    const FoundWay found =
        search_stations(places.layers, legs, {.most_skipped = places.layers.size()});
    if (found.way.empty() || level_length(found.way) > kWorthWhile * length) break;
    best = found.way;
  }
  return best;
}

Way without_tiny_legs(const Way& way, double least, const FlyableLegs::IsFree& is_free,
                      const std::function<bool(const Way&)>& is_flyable) {
  Way kept = way;
  const auto drops = [&](std::size_t i) {
    const std::size_t first = i > 2 ? i - 3 : 0, end = std::min(kept.size(), i + 4);
    Way around(kept.begin() + static_cast<std::ptrdiff_t>(first),
               kept.begin() + static_cast<std::ptrdiff_t>(end));
    around.erase(around.begin() + static_cast<std::ptrdiff_t>(i - first));
    if (is_free && !is_free(kept[i - 1], kept[i + 1])) return false;
    if (!is_flyable(around)) {
      if (i < 2) return false;
      double& before = around[i - 1 - first].z();
      before += kEased * (kept[i + 1].z() - before);
      if (!is_flyable(around)) return false;
      kept[i - 1].z() = before;
    }
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
    return true;
  };
  for (std::size_t i = 1; i < kept.size();) {
    const bool tiny = (kept[i] - kept[i - 1]).norm() < least;
    const bool dropped = tiny && ((i + 1 < kept.size() && drops(i)) || (i > 1 && drops(i - 1)));
    if (!dropped) ++i;
  }
  return kept;
}

}  // namespace skein::refiners
