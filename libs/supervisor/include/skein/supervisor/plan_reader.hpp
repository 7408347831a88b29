// SPDX-License-Identifier: Apache-2.0
// From the steps of a symbolic plan to elementary tasks.
#pragma once

#include "skein/foundation/result.hpp"
#include "skein/htn/plan.hpp"
#include "skein/htn/term_store.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// Every step that is not internal must have the shape
///   (!task-NAME ID DEPENDENCES PARAMS START DURATION TIME-CONSTRAINTS ORIGIN)
/// or that of a stop, (!stop-NAME ID …), whose dependences become those of the stop of the task of
/// that id. PARAMS is a list of (KEY VALUE…): `type`, `sync`, `energy`, `way`, `open-ended` are the
/// reader's, all others go to the functional layer as they are. Names come back in the letters that
/// `knowledge` has them in. With the plan's tree tasks have their methods. Failure: every step that
/// has another shape, in words. Source: docs/comets-domain.md.
Result<mission::ElementaryPlan, Failure> read_plan(const htn::TermStore& store,
                                                   const htn::Plan& plan,
                                                   const Knowledge& knowledge, MissionTime origin);

}  // namespace skein::supervisor
