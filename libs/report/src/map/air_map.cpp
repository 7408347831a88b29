// SPDX-License-Identifier: Apache-2.0
// Reserved air on the map, as volumes around ways: the page's script shows what is had at the
// instant of its cursor. Source: spec 6.4.
#include <algorithm>

#include "page/views.hpp"
#include "story/air_story.hpp"

namespace skein::report {

namespace {

constexpr std::size_t kMostWays = 4000;

struct Reservation {
  const AirUse& use;
  Span span;
  std::vector<AirPiece> pieces;
};

/// As it was granted, while it is flown; then where it ends, until the next.
std::vector<Reservation> reservations_of(const std::vector<AirUse>& uses, double end) {
  std::vector<Reservation> result;
  for (std::size_t i = 0; i < uses.size() && result.size() < kMostWays; ++i) {
    const AirUse& use = uses[i];
    if (use.pieces.empty()) continue;
    result.push_back({use, use.span, use.pieces});
    if (!use.ends_in_the_air) continue;
    const auto next =
        std::find_if(uses.begin() + static_cast<std::ptrdiff_t>(i) + 1, uses.end(),
                     [&](const AirUse& one) { return one.uav == use.uav && !one.pieces.empty(); });
    const Span stays{use.span.to, next == uses.end() ? end : next->span.from};
    if (stays.to > stays.from) result.push_back({use, stays, {use.pieces.back()}});
  }
  return result;
}

std::string heights(const std::vector<AirPiece>& pieces) {
  double floor = pieces.front().floor, ceiling = pieces.front().ceiling;
  for (const AirPiece& one : pieces) {
    floor = std::min(floor, one.floor);
    ceiling = std::max(ceiling, one.ceiling);
  }
  const std::string top = "up to " + short_number(ceiling, 0) + " m";
  return floor < 0 ? top : short_number(floor, 0) + " m " + top;
}

/// Lines as wide as the air, with round ends: their group makes one shade of them.
void write_reservation(Markup& out, const Run& run, const MapFrame& f, const Reservation& one) {
  out.open("g", {{"class", "reserved " + colour_class(one.use.uav)},
                 {"data-from", one.span.from},
                 {"data-to", one.span.to}});
  out.title(run.story.uavs[one.use.uav].name + " has " + heights(one.pieces) + ": " + one.use.what +
            ", " + clock_text(one.span.from) + " to " + clock_text(one.span.to));
  for (const AirPiece& piece : one.pieces) {
    const Point from = f(piece.from.x, piece.from.y), to = f(piece.to.x, piece.to.y);
    out.leaf("line", {{"x1", from.x},
                      {"y1", from.y},
                      {"x2", to.x},
                      {"y2", to.y},
                      {"stroke-width", 2 * piece.radius * f.scale}});
  }
  out.close();
}

}  // namespace

void write_air_map(Markup& out, const Run& run, const MapFrame& frame) {
  const std::vector<AirUse> uses = tell_air(run.journal, run.story);
  if (uses.empty()) return;
  out.open("g", {{"class", "air-map"}});
  for (const Reservation& one : reservations_of(uses, run.story.time.to))
    write_reservation(out, run, frame, one);
  out.close().line_break();
}

}  // namespace skein::report
