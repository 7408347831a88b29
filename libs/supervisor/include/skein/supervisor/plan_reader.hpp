// SPDX-License-Identifier: Apache-2.0
// Reads elementary tasks from the steps of a symbolic plan.
#pragma once

#include "skein/foundation/result.hpp"
#include "skein/htn/plan.hpp"
#include "skein/htn/term_store.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// The elementary plan of `plan`. Every step that is not internal must have the shape
///   (!task-NAME ID DEPENDENCES PARAMS START DURATION TIME-CONSTRAINTS ORIGIN)
/// or, for a stop, (!stop-NAME ID …): its dependences become the `stop` of the task with that id.
/// PARAMS is a list of (KEY VALUE…): the reader interprets `type`, `sync`, `energy`, `way` and
/// `open-ended`; all others are passed on to the functional layer. Names get back the spelling that
/// they have in `knowledge` (the planner's symbols ignore case). If the plan has its decomposition
/// tree, the tasks get the labels of their methods. Failure: every step of another shape, in words.
/// Source: docs/comets-domain.md.
Result<mission::ElementaryPlan, Failure> read_plan(const htn::TermStore& store,
                                                   const htn::Plan& plan,
                                                   const Knowledge& knowledge, MissionTime origin);

}  // namespace skein::supervisor
