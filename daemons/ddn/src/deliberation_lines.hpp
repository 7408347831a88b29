// SPDX-License-Identifier: Apache-2.0
// Lines of the event log about plans: kinds plan, planned, answer, goal,
// decision (docs/journal.md).
#pragma once

#include "skein/blackboard/wire_state.hpp"
#include "skein/journal/record.hpp"
#include "skein/mission/autonomy.hpp"
#include "skein/mission/elementary_plan.hpp"
#include "skein/translation/journal_lines.hpp"

namespace skein::ddn {

// The writer is the UAV that the line is about.

journal::Record plan_line(const translation::Writer& writer, const mission::PlanReport& report);
/// The record (kind planned) of one task of a plan revision.
journal::Record planned_line(const translation::Writer& writer, std::uint64_t revision,
                             const wire::PlanEntry& task, const executive::Parameters& parameters);
/// The outcome of a mission, or its evaluation: kind answer.
journal::Record outcome_line(const translation::Writer& writer,
                             const mission::MissionOutcome& outcome);
journal::Record goal_line(const translation::Writer& writer, const mission::GoalStatus& goal);
journal::Record decision_line(const translation::Writer& writer, const mission::Decision& decision);

}  // namespace skein::ddn
