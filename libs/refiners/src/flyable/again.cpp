// SPDX-License-Identifier: Apache-2.0
#include "flyable/again.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "flyable/lower.hpp"
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
/// Of a leg's rise: what two slopes that are as steep as can be flown miss when they become one, by
/// rounding or since the straight way is a little shorter than around a bend.
constexpr std::array kEased = {1e-8, 1e-7, 1e-6, 1e-5, 1e-4};

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

/// Leaves points of a way out.
class TinyLegs {
 public:
  TinyLegs(const FlyableLegs::IsFree& is_free, const std::function<bool(const Way&)>& is_flyable,
           double radius, const Way& way)
      : is_free_(is_free), is_flyable_(is_flyable), radius_(radius), kept_(way) {}

  Way dropped(double least) {
    for (std::size_t i = 1; i < kept_.size();) {
      const bool tiny = (kept_[i] - kept_[i - 1]).norm() < least;
      const bool dropped = tiny && (drops(i) || (i > 1 && drops(i - 1)));
      if (tiny && !dropped) lengthens(i, least);
      if (!dropped) ++i;
    }
    return kept_;
  }

 private:
  /// The last cannot be left out; where the leg that comes of it is a little too steep, one of its
  /// ends is raised or lowered.
  bool drops(std::size_t i) {
    if (i + 1 == kept_.size()) return false;
    Way without = kept_;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
    const double rise = kept_[i + 1].z() - kept_[i - 1].z();
    if (takes(without, i)) return true;
    for (const double eased : kEased)
      for (const std::size_t end : {i - 1, i}) {
        if (end == 0 || end + 1 == without.size()) continue;
        Way moved = without;
        moved[end].z() += (end == i ? -eased : eased) * rise;
        if (takes(moved, end)) return true;
      }
    return false;
  }

  /// Begins the leg to a point earlier on the arc or leg before it, or ends it later: both turns
  /// get less where it lies between two arcs, one way and the other.
  bool lengthens(std::size_t i, double least) {
    constexpr double kForBend = 1.1;
    const double step = kForBend * (least - (kept_[i] - kept_[i - 1]).norm());
    const auto moves = [&](std::size_t beyond, std::size_t end, std::size_t other) {
      for (const bool tight : {false, true}) {
        Way moved = kept_;
        moved[end] = back_along(kept_[beyond], kept_[end], kept_[other], step, tight);
        if ((moved[i] - moved[i - 1]).norm() >= least &&
            (moved[end] - moved[beyond]).norm() >= least && takes(moved, end))
          return true;
      }
      return false;
    };
    return (i > 1 && moves(i - 2, i - 1, i)) || (i + 1 < kept_.size() && moves(i + 1, i, i - 1));
  }

  /// So far before the end of a leg, on the arc of which it is a chord: as tight as can be flown,
  /// or as wide as its turn to the next says.
  Vector3 back_along(const Vector3& begin, const Vector3& end, const Vector3& next, double step,
                     bool tight) const {
    const Vector2 in = (end - begin).head<2>(), out = (next - end).head<2>();
    const double turn = world::wrapped(heading_of(out) - heading_of(in));
    const double most = std::asin(std::min(1.0, in.norm() / (2 * radius_)));
    const double half = tight ? std::copysign(most, turn) : std::clamp(turn, -most, most);
    const double back = heading_of(in) + half * (1 - step / in.norm());
    const double fall = step * (end - begin).z() / in.norm();
    return end - Vector3(step * std::cos(back), step * std::sin(back), fall);
  }

  /// Where the legs around a point are free, and what is around can be flown.
  bool takes(const Way& way, std::size_t point) {
    for (std::size_t i = std::max<std::size_t>(point, 1); i < std::min(way.size(), point + 2); ++i)
      if (is_free_ && !is_free_(way[i - 1], way[i])) return false;
    const std::size_t first = point > 3 ? point - 4 : 0, end = std::min(way.size(), point + 5);
    if (!is_flyable_(Way(way.begin() + static_cast<std::ptrdiff_t>(first),
                         way.begin() + static_cast<std::ptrdiff_t>(end))))
      return false;
    kept_ = way;
    return true;
  }

  const FlyableLegs::IsFree& is_free_;
  const std::function<bool(const Way&)>& is_flyable_;
  double radius_;
  Way kept_;
};

}  // namespace

Way flown_again(const Way& way, FlyableLegs& legs, const FlightLimits& limits,
                const EndHeadings& headings, const Floor& floor) {
  Way best = way;
  for (int round = 0; round < kRounds; ++round) {
    const double length = level_length(best);
    Places places(best, std::max(limits.radius, length / kMostPlaces));
    if (places.layers.size() < 2) break;
    if (headings.from) places.layers.front().stations[0].pose.heading = *headings.from;
    if (headings.to) places.layers.back().stations[0].pose.heading = *headings.to;
    if (floor) add_lower_stations(places.layers, limits, floor);
    const FoundWay found =
        search_stations(places.layers, legs, {.most_skipped = places.layers.size()});
    if (found.way.empty() || level_length(found.way) > kWorthWhile * length) break;
    best = found.way;
  }
  return best;
}

Way without_tiny_legs(const Way& way, double least, double radius,
                      const FlyableLegs::IsFree& is_free,
                      const std::function<bool(const Way&)>& is_flyable) {
  return TinyLegs{is_free, is_flyable, radius, way}.dropped(least);
}

}  // namespace skein::refiners
