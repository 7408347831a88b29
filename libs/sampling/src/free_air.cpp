// SPDX-License-Identifier: Apache-2.0
#include "free_air.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

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

}  // namespace

FreeAir::FreeAir(const refiners::PathQuery& query, const world::World& world, MissionTime until)
    : query_(query),
      world_(world),
      scene_(world, {.clearance = query.clearance,
                     .reserved = query.reserved,
                     .when = {query.depart, until}}) {
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

/// The surface is a plane or a hyperbolic paraboloid between the lines of the terrain's grid: with
/// samples every eighth of a cell it sags below the segment's height by at most 1/64 of what it
/// does over a whole cell.
bool FreeAir::is_low_enough(const Vector3& from, const Vector3& to) const {
  const double spacing = world_.terrain.spec().cell / 8;
  const auto steps = static_cast<int>(std::ceil((to - from).head<2>().norm() / spacing)) + 1;
  for (int i = 0; i <= steps; ++i)
    if (height(from + (to - from) * i / steps) > query_.vehicle.ceiling + kSlack) return false;
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
