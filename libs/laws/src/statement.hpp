// SPDX-License-Identifier: Apache-2.0
// High-level tasks as the log states them, read back.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/mission/high_level_task.hpp"

namespace skein::laws {

/// "perceive P1 120 [end-before 300]": the inverse of mission::to_text. What it cannot read it
/// leaves out: laws then have nothing to say of it.
mission::HighLevelTask task_from(std::string_view statement);

std::optional<double> number_of(const mission::Argument& argument);
std::vector<std::string> names_of(const mission::Argument& argument);

}  // namespace skein::laws
