// SPDX-License-Identifier: Apache-2.0
// Reads high-level tasks back from the log's statements.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/mission/high_level_task.hpp"

namespace skein::laws {

/// "perceive P1 120 [end-before 300]": the inverse of mission::to_text. Unreadable parts are left
/// out, and not checked by laws.
mission::HighLevelTask task_from(std::string_view statement);

std::optional<double> number_of(const mission::Argument& argument);
std::vector<std::string> names_of(const mission::Argument& argument);

}  // namespace skein::laws
