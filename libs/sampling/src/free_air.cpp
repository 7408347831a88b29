// SPDX-License-Identifier: Apache-2.0
#include "free_air.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace skein::sampling {
namespace {

using refiners::Refusal;
using refiners::RefusalKind;
using world::Vector3;

/// What rounding may add to a height [m].
constexpr double kSlack = 1e-6;

std::string sentence(const char* format, const Vector3& at, const std::string& rest) {
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), format, at.x(), at.y(), at.z());
  return text.data() + rest;
}

/// The fractions of a segment at which it crosses lines, in their order, with 0 and 1.
std::vector<double> parts_between_lines(const world::TerrainSpec& terrain, const Vector3& from,
                                        const Vector3& to) {
  std::vector<double> parts = {0, 1};
  const auto add = [&](double a, double b, double low, double high) {
    const auto cross = [&](double line) {
      if (line > std::min(a, b) && line < std::max(a, b)) parts.push_back((line - a) / (b - a));
    };
    const double first = std::max(0.0, std::floor((std::min(a, b) - low) / terrain.cell));
    const double last = std::floor((std::min(std::max(a, b), high) - low) / terrain.cell);
    for (double i = first; i <= last; ++i) cross(low + i * terrain.cell);
    cross(high);
  };
  add(from.x(), to.x(), terrain.west, terrain.east);
  add(from.y(), to.y(), terrain.south, terrain.north);
  std::sort(parts.begin(), parts.end());
  return parts;
}

/// Of a quadratic function with these values at the begin, in the middle and at the end.
double highest_between(double begin, double middle, double end) {
  const double curve = 2 * (begin + end) - 4 * middle;
  const double slope = end - begin - curve;
  if (curve >= 0 || slope <= 0 || slope >= -2 * curve) return std::max(begin, end);
  return begin - slope * slope / (4 * curve);
}

}  // namespace

FreeAir::FreeAir(const refiners::PathQuery& query, const world::World& world, MissionTime until,
                 const refiners::Budget& budget)
    : query_(query),
      world_(world),
      scene_(world, {.clearance = query.clearance,
                     .reserved = query.reserved,
                     .when = {query.depart, until},
                     .time_is_up = budget.time_is_up}) {
  if (query.contact) contact_.emplace(*query.contact, world);
}

Vector3 FreeAir::low() const { return world_.airspace.origin; }
Vector3 FreeAir::high() const {
  const world::AirspaceGrid& grid = world_.airspace;
  return grid.origin + grid.voxel * Vector3(grid.size[0], grid.size[1], grid.size[2]);
}

double FreeAir::height(const Vector3& point) const {
  return point.z() - world_.terrain.elevation(point.x(), point.y());
}

/// Exact: between the lines of the terrain's grid the ground is a quadratic function of the way.
bool FreeAir::is_low_enough(const Vector3& from, const Vector3& to) const {
  const double limit = query_.vehicle.ceiling + kSlack;
  if (std::max(from.z(), to.z()) - world_.terrain.lowest() <= limit) return true;
  const std::vector<double> parts = parts_between_lines(world_.terrain.spec(), from, to);
  const auto height_at = [&](double part) { return height(from + part * (to - from)); };
  double before = height_at(0);
  if (before > limit) return false;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const double middle = height_at((parts[i - 1] + parts[i]) / 2), after = height_at(parts[i]);
    if (after > limit || highest_between(before, middle, after) > limit) return false;
    before = after;
  }
  return true;
}

bool FreeAir::is_free(const Vector3& point, double margin) const {
  return height(point) <= query_.vehicle.ceiling + kSlack &&
         !scene_.collides(point, query_.vehicle.body_radius + margin) &&
         (!contact_ || contact_->has_link(point));
}

bool FreeAir::is_free(const Vector3& from, const Vector3& to, double margin) const {
  return is_low_enough(from, to) &&
         !scene_.collides(from, to, query_.vehicle.body_radius + margin) &&
         (!contact_ || contact_->has_link(from, to));
}

std::optional<Refusal> FreeAir::refusal_at(const Vector3& point, const std::string& field) const {
  constexpr const char* kPlace = "(%.1f, %.1f, %.1f) ";
  if (const auto conflict = scene_.first_conflict(point, query_.vehicle.body_radius))
    return Refusal{RefusalKind::kBlocked, field,
                   sentence(kPlace, point, "is in " + conflict->with + ", or too close to it")};
  if (height(point) > query_.vehicle.ceiling + kSlack) {
    std::array<char, 96> figures{};
    std::snprintf(figures.data(), figures.size(),
                  "is %.1f m over the ground; the ceiling is %.1f m", height(point),
                  query_.vehicle.ceiling);
    return Refusal{RefusalKind::kBeyondVehicle, field, sentence(kPlace, point, figures.data())};
  }
  if (contact_ && !contact_->has_link(point))
    return Refusal{RefusalKind::kNoContact, field,
                   sentence(kPlace, point, "has no link to whom contact is kept with")};
  return std::nullopt;
}

Vector3 FreeAir::any_point(Random& random) const {
  const Vector3 bottom = low(), top = high();
  const double x = random.uniform(bottom.x(), top.x());
  const double y = random.uniform(bottom.y(), top.y());
  const double ground = world_.terrain.elevation(x, y);
  const double lowest = std::clamp(ground + query_.clearance, bottom.z(), top.z());
  const double highest =
      std::clamp(ground + std::max(query_.vehicle.ceiling, query_.clearance), lowest, top.z());
  return {x, y, random.uniform(lowest, highest)};
}

}  // namespace skein::sampling
