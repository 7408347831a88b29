// SPDX-License-Identifier: Apache-2.0
#include "partition/checks.hpp"

#include <cmath>
#include <string>

#include "common/shared_checks.hpp"
#include "skein/refiners/checks.hpp"

namespace skein::refiners {
namespace {

using world::Polygon;
using world::Vector2;

/// The first corner that turns against the sense of the polygon, more than rounding does.
std::optional<std::size_t> reflex_corner(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  const auto turn = [&](std::size_t i) {
    const Vector2 in = polygon[i] - polygon[(i + n - 1) % n];
    const Vector2 out = polygon[(i + 1) % n] - polygon[i];
    return (in.x() * out.y() - in.y() * out.x()) / (in.norm() * out.norm());
  };
  double twice_area = 0;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Vector2 a = polygon[i] - polygon[0], b = polygon[i + 1] - polygon[0];
    twice_area += a.x() * b.y() - a.y() * b.x();
  }
  for (std::size_t i = 0; i < n; ++i)
    if (std::copysign(1.0, twice_area) * turn(i) < -1e-9) return i;
  return std::nullopt;
}

std::optional<Refusal> check_member(const Member& member, const std::string& field) {
  if (!member.start.allFinite())
    return bad(field + ".start", "every coordinate must be a finite number");
  if (auto problem = check_positive(member.swath, field + ".swath")) return problem;
  if (auto problem = check_positive(member.altitude, field + ".altitude")) return problem;
  if (!(member.speed >= 0 && std::isfinite(member.speed)))
    return bad(field + ".speed", "a speed is a finite number, at least 0");
  if (!(member.busy >= 0 && std::isfinite(member.busy)))
    return bad(field + ".busy", "a time is a finite number, at least 0");
  if (auto problem = check_vehicle(member.vehicle)) {
    problem->field = field + "." + problem->field;
    return problem;
  }
  if (member.share) return check_positive(*member.share, field + ".share");
  return std::nullopt;
}

}  // namespace

std::optional<Refusal> check_partition(const PartitionQuery& query, const world::World& world) {
  if (auto problem = check_polygon(query.area, "area")) return problem;
  if (auto problem = check_in_world(query.area, world, "area")) return problem;
  if (const auto corner = reflex_corner(query.area))
    return bad("area", "it is not convex: corner " + std::to_string(*corner + 1) +
                           " points inwards; give its convex hull, or convex pieces of it");
  if (!(query.apart >= 0) || !std::isfinite(query.apart))
    return bad("apart", "a distance is a finite number, at least 0");
  if (query.members.empty()) return bad("members", "there is nobody to share the area among");
  if (query.members.size() > kMostMembers)
    return bad("members", std::to_string(query.members.size()) + " members: at most " +
                              std::to_string(kMostMembers));
  for (std::size_t i = 0; i < query.members.size(); ++i) {
    const std::string field = "members." + std::to_string(i);
    if (auto problem = check_member(query.members[i], field)) return problem;
    if (query.members[i].share.has_value() != query.members[0].share.has_value())
      return bad(field + ".share", "either every member has a share or none has");
  }
  return std::nullopt;
}

}  // namespace skein::refiners
