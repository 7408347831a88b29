// SPDX-License-Identifier: Apache-2.0
// Executive tasks made from the tasks of a role.
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

/// Sweeps the remainder of the UAV's part of an area; made of two executive tasks.
inline constexpr std::string_view kMapArea = "map-area";
/// Stays beside a moving target, by one flight after another.
inline constexpr std::string_view kFollow = "follow";

/// The context of a role's task.
struct RoleTaskContext {
  const RolePlay& play;
  const Outlook& outlook;
  const world::VehicleState& state;
  Duration done = {};      ///< part of an interrupted perception that was done before
  std::string allocation;  ///< name of the current allocation of roles
};

/// An executive task without its id and preconditions. A goto gets a way around obstacles; a
/// perception is shortened by the part already done; meetings of two roles are paired by their
/// order in the roles (first with first). Refused: a value or a way is missing.
Result<executive::Task, Failure> make_task(const interaction::Componel& componel,
                                           const std::string& subject,
                                           const RoleTaskContext& context);

/// Whether it waits for other roles.
bool is_meeting(const interaction::Task& task);

/// Of the own part of a shared area.
bool is_mapping(const interaction::Task& task);

/// The zone named by an expression of a role; nothing: there is no such zone.
std::optional<world::Polygon> zone_of(const config::Value& named, const Arguments& scope,
                                      const world::World& world);

/// A goto along `way`, without its id.
executive::Task flight_along(const refiners::Way& way);
/// A perception with `device` while `flight` runs, without its id.
executive::Task look_along(executive::TaskId flight, const std::string& device);

/// The duration given by the task's parameters; zero: none is given.
Duration duration_of(const interaction::Task& task, const RolePlay& play);

}  // namespace skein::decision_node
