// SPDX-License-Identifier: Apache-2.0
#include "watch/stand.hpp"

#include <algorithm>
#include <cmath>

#include "flight/flight_times.hpp"

namespace skein::supervisor {

namespace {

/// Radii from its middle within which it counts as on its circle, which it may still be joining.
constexpr double kOnCircle = 1.5;
/// [m] Who is so far above or below its plan's place has got out of the way of others there.
constexpr double kOffHeight = 10;

}  // namespace

std::optional<world::Vector3> circled(const Book& book, const Beliefs& beliefs) {
  const world::VehicleState& vehicle = beliefs.vehicle();
  if (beliefs.model().hovers || !vehicle.airborne) return std::nullopt;
  std::optional<world::Vector3> over;
  for (const auto& [id, entry] : book.tasks) {
    if (entry.task.way.empty() || !entry.seen.started || entry.has_not_moved()) continue;
    if (!entry.over()) return std::nullopt;
    over = entry.done() ? std::optional(entry.task.way.back()) : std::nullopt;
  }
  const double circle = kOnCircle * stay_radius(beliefs.model());
  const bool near = over && (vehicle.position - *over).head<2>().norm() <= circle;
  if (!near) return std::nullopt;
  const double height = vehicle.position.z();
  return std::abs(height - over->z()) <= kOffHeight ? *over
                                                    : world::Vector3(over->x(), over->y(), height);
}

bool was_stopped(const Book& book, const Beliefs& beliefs) {
  if (beliefs.model().hovers || !beliefs.vehicle().airborne) return false;
  const Entry* last = nullptr;
  for (const auto& [id, entry] : book.tasks)
    if (!entry.task.way.empty() && entry.seen.started && !entry.has_not_moved()) last = &entry;
  return last != nullptr && last->over() && !last->done();
}

world::Vector3 place_of_vehicle(const Book& book, const Beliefs& beliefs) {
  return circled(book, beliefs).value_or(beliefs.vehicle().position);
}

std::optional<world::Vector3> stand_of(const Entry& entry, const Book& book,
                                       const Beliefs& beliefs) {
  const auto flies = [&](const mission::Dependence& on) {
    const Entry* other = book.find(on.task);
    return on.kind == mission::DependenceKind::kRunning && other != nullptr &&
           !other->task.way.empty();
  };
  const auto& on = entry.task.dependences;
  if (!entry.task.way.empty() || std::any_of(on.begin(), on.end(), flies)) return std::nullopt;
  Whereabouts there{place_of_vehicle(book, beliefs), beliefs.vehicle().airborne};
  for (const auto& [id, before] : book.tasks) {
    if (id >= entry.task.id) break;
    if (book.counts(before)) there = after(there, {before.task});
  }
  return there.airborne ? std::optional(there.position) : std::nullopt;
}

}  // namespace skein::supervisor
