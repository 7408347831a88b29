// SPDX-License-Identifier: Apache-2.0
// The progress of a high-level task, from the observations of its elementary tasks.
#pragma once

#include <optional>

#include "book/book.hpp"
#include "skein/mission/progress.hpp"

namespace skein::supervisor {

/// The progress by all tasks that the goal and its parts ever had, including withdrawn ones, in the
/// order of their ids. A perception counts for the time during which it and its companion motion
/// both ran; tasks taken over by somebody else do not count. With `until`, tasks under way count up
/// to that instant; without it, only tasks that are over. Cost: linear in the tasks of the book.
mission::Progress progress_of(const Book& book, GoalId goal, std::optional<MissionTime> until);

/// The companion of a task: the one that must be running when the task starts; null if there is
/// none.
const Entry* companion_of(const Book& book, const Entry& entry);

/// How much perception is missing although the companion was done in full: for a wait, what is
/// short of its least duration; for a flight, all of it if the device never perceived. (A node that
/// was down meanwhile hears late that the companion began and is over.) Zero if the companion
/// itself was cut short.
Duration missed_beside(const Entry& look, const Entry& companion);

/// The motion along which the task perceives: its companion, if that has a way; null if the task
/// perceives in place, or not at all.
const Entry* flown_along(const Book& book, const Entry& entry);

/// The number of way-points reached, after the first, when a vehicle that had reached `passed` of
/// them has flown straight `from` one place `to` another. A way-point is reached within `reach`
/// [m], and only in turn.
std::size_t passed_after(const std::vector<world::Vector3>& way, std::size_t passed,
                         const world::Vector3& from, const world::Vector3& to, double reach);

}  // namespace skein::supervisor
