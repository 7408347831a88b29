// SPDX-License-Identifier: Apache-2.0
// What was done of a high-level task, by what was seen of its elementary tasks.
#pragma once

#include <optional>

#include "book/book.hpp"
#include "skein/mission/progress.hpp"

namespace skein::supervisor {

/// Of all tasks that the goal and its parts ever had, those withdrawn too, in the order of their
/// ids. A perception counts as long as it and the motion it runs with both went on; what was lost
/// to somebody else counts for nothing. With `until` what is under way counts up to then, without
/// it only what is over. Cost: linear in the tasks of the book.
mission::Progress progress_of(const Book& book, GoalId goal, std::optional<MissionTime> until);

/// What it runs with: the task that must be running when it starts; null if there is none.
const Entry* companion_of(const Book& book, const Entry& entry);

/// Of what a device was to perceive beside its companion, which is done in full, what it did not:
/// of a wait what is short of its least, of a way all of it if it never perceived. (A node that was
/// away meanwhile hears late that the companion began, and that it is over.) Nothing of a companion
/// that was cut short itself.
Duration missed_beside(const Entry& look, const Entry& companion);

/// The motion that the task perceives along: what it waits for to be running, when that flies
/// somewhere; null when it perceives in place, or not at all.
const Entry* flown_along(const Book& book, const Entry& entry);

/// How many way-points behind its first a vehicle has reached that had reached `passed` of them and
/// now flew straight `from` one place `to` another: it comes within `reach` [m] of each in turn.
std::size_t passed_after(const std::vector<world::Vector3>& way, std::size_t passed,
                         const world::Vector3& from, const world::Vector3& to, double reach);

}  // namespace skein::supervisor
