// SPDX-License-Identifier: Apache-2.0
// What a role asks for, as a task of the executive.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "interaction/places.hpp"
#include "interaction/role_play.hpp"
#include "skein/executive/task.hpp"
#include "skein/refiners/flight.hpp"
#include "skein/refiners/path.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::decision_node {

/// Sweeps what is left of one's part of an area; two tasks of the executive make it.
inline constexpr std::string_view kMapArea = "map-area";
/// Stays beside what moves, by one flight after the other.
inline constexpr std::string_view kFollow = "follow";

/// What a role's task is made under.
struct RoleTaskContext {
  const RolePlay& play;
  const Outlook& outlook;
  const world::VehicleState& state;
  Duration done = {};      ///< of a perception that was interrupted before
  std::string allocation;  ///< names the allocation of roles that is in force
};

/// Without its id and what it waits for. A goto is a way around what is in between; a perception is
/// shorter by what was done of it; who meets whom is told by the place of a meeting among those of
/// its role: the first of one role is the first of the other. Refused: a value or a way is missing.
Result<executive::Task, Failure> make_task(const interaction::Componel& componel,
                                           const std::string& subject,
                                           const RoleTaskContext& context);

/// The zone that an expression of a role names; nothing: there is no such zone.
std::optional<world::Polygon> zone_of(const config::Value& named, const Arguments& scope,
                                      const world::World& world);

/// A goto; without its id.
executive::Task flight_along(const refiners::Way& way);
/// Looks with a device while that flight runs; without its id.
executive::Task look_along(executive::TaskId flight, const std::string& device);

/// How long it lasts by its parameters; zero: it does not say.
Duration duration_of(const interaction::Task& task, const RolePlay& play);

}  // namespace skein::decision_node
