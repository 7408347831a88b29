// SPDX-License-Identifier: Apache-2.0
// What a role asks for, as a task of the executive.
#pragma once

#include <string>

#include "interaction/places.hpp"
#include "interaction/role_play.hpp"
#include "skein/executive/task.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::decision_node {

/// What a role's task is made under.
struct RoleTaskContext {
  const RolePlay& play;
  const Outlook& outlook;
  const world::VehicleState& state;
  Duration done = {};      ///< of a perception that was interrupted before
  std::string allocation;  ///< names the allocation of roles that is in force
};

/// Whether role tasks of that type can be made: goto, takeshot-while-waiting, synchro,
/// wait-until-synchro.
bool can_make(const std::string& type);

/// Without its id and what it waits for. A goto is a way around what is in between; a perception is
/// shorter by what was done of it; who meets whom is told by the place of a meeting among those of
/// its role: the first of one role is the first of the other. Refused: a value or a way is missing.
Result<executive::Task, Failure> make_task(const interaction::Componel& componel,
                                           const std::string& subject,
                                           const RoleTaskContext& context);

/// How long it lasts by its parameters; zero: it does not say.
Duration duration_of(const interaction::Task& task, const RolePlay& play);

}  // namespace skein::decision_node
