// SPDX-License-Identifier: Apache-2.0
// Pieces of a mission that are drawn by themselves.
#pragma once

#include <string>
#include <vector>

#include "skein/foundation/random.hpp"

namespace skein::random_missions {

/// Rounded to a whole number.
std::string whole(double number);
/// Rounded to one decimal.
std::string tenths(double number);
/// Times of a high-level task.
std::string draw_times(Random& random);
/// A high-level task of which it is asked what it would take.
std::string draw_question_task(Random& random);
/// A fault: for a while, or for good, the UAV takes no task of a type.
std::string draw_refusals(Random& random, const std::string& uav);

/// A fault: one of the daemons dies and comes back with what it knew.
std::string draw_death(Random& random, const std::vector<std::string>& daemons);

}  // namespace skein::random_missions
