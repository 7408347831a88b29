// SPDX-License-Identifier: Apache-2.0
#include "merging/vehicle_air.hpp"

#include <algorithm>
#include <utility>

#include "skein/world/segment.hpp"

namespace skein::decision_node {

namespace {

constexpr double kAtRest = 0.5;  // [m/s]

}  // namespace

merging::Volumes Flown::air() const {
  merging::Volumes all = behind;
  const merging::Volumes own = airway.way ? airway.way->left() : airway.air;
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

bool Flown::stopped_at(double height, double within) {
  if (airway.way) return false;
  const merging::Volumes before = airway.air;
  for (merging::Volume& column : airway.air) {
    const double floor = std::max(column.floor, height - within);
    const double ceiling = std::min(column.ceiling, height + within);
    if (floor >= ceiling) continue;
    column.floor = floor;
    column.ceiling = ceiling;
  }
  return airway.air != before;
}

bool Flown::passed(const world::Vector3& position) {
  if (!airway.way || !airway.way->passed(position)) return false;
  if (!airway.way->is_whole()) behind.clear();
  return true;
}

void Flown::stays_on(const Circle& circle, const merging::Margins& margins) {
  const double around = circle.radius + margins.apart;
  const auto off = [&](const merging::Volume& piece) {
    return world::to_segment(circle.center, piece.from, piece.to);
  };
  const merging::Volume* nearest = nullptr;
  merging::Volumes all = air();
  for (const merging::Volume& piece : all) {
    const bool has_it = off(piece) + around <= piece.radius && piece.floor <= circle.lowest &&
                        circle.highest <= piece.ceiling;
    if (has_it && (nearest == nullptr || off(piece) < off(*nearest))) nearest = &piece;
  }
  if (nearest != nullptr) {
    airway.air = {{circle.center, circle.center,
                   std::min(margins.hold, nearest->radius - off(*nearest)),
                   std::max(nearest->floor, circle.lowest - margins.level),
                   std::min(nearest->ceiling, circle.highest + margins.level)}};
  } else {
    std::erase_if(all, [&](const auto& piece) { return off(piece) > piece.radius + around; });
    airway.air = std::move(all);
  }
  airway.way.reset();
  behind.clear();
}

const world::VehicleState& VehicleAir::state() const {
  static const world::VehicleState kUnseen;
  return seen_ ? *seen_ : kUnseen;
}

bool VehicleAir::see(const world::VehicleState& state, MissionTime now) {
  if (!seen_ && state.airborne) rest_ = state.position;
  seen_ = state;
  if (!state.airborne) return false;
  return flies() ? flown_->passed(state.position) : settles(now);
}

bool VehicleAir::settles(MissionTime now) {
  if (!circling_) return false;
  circling_->see(state(), now);
  const auto circle = circling_->seen();
  if (!circle) return false;
  circling_.reset();
  flown_->stays_on(*circle, margins_);
  return true;
}

void VehicleAir::begin(Flown flown) {
  flown_ = std::move(flown);
  rest_.reset();
  circling_.reset();
}

bool VehicleAir::over(bool ended) {
  flown_->over = true;
  flown_->ended = ended;
  if (!ended && !margins_.hovers && flown_->airway.way) circling_.emplace(margins_.settled);
  return !ended && state().airborne && flown_->stopped_at(state().position.z(), margins_.slope);
}

bool VehicleAir::come_to_rest() {
  const bool airborne = state().airborne;
  if (!airborne && !flies()) {
    flown_.reset();
    rest_.reset();
    circling_.reset();
    return true;
  }
  if (!flown_ || flies() || !airborne) return true;
  const auto end = flown_->ended ? flown_->airway.end : std::nullopt;
  const bool there = end && (*end - state().position).norm() <= margins_.settled;
  const bool still = margins_.hovers && state().velocity.norm() <= kAtRest;
  const bool circles = !margins_.hovers && end;
  if (!there && !still && !circles) return false;
  rest_ = there || circles ? *end : state().position;
  flown_.reset();
  return true;
}

bool VehicleAir::stays() const {
  const bool circles = flown_ && flown_->over && !margins_.hovers;
  return state().airborne && (circles || (!flown_ && rest_));
}

merging::Volumes VehicleAir::air() const {
  if (flown_) return flown_->air();
  return rest_ ? merging::Volumes{stay_at(*rest_, margins_)} : merging::Volumes();
}

}  // namespace skein::decision_node
