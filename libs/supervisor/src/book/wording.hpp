// SPDX-License-Identifier: Apache-2.0
// Texts for people: they name goals instead of the internal ids of tasks.
#pragma once

#include <functional>
#include <string>

#include "skein/mission/elementary_plan.hpp"

namespace skein::supervisor {

/// "the takeshot of goal 702".
std::string in_words(const mission::ElementaryTask& task);

/// The text with each "WORD NUMBER" replaced by `name(NUMBER)`, unless that is empty or stands
/// there already. Cost: linear in the text, plus the calls.
std::string with_names(const std::string& text, const std::string& word,
                       const std::function<std::string(std::uint64_t)>& name);

}  // namespace skein::supervisor
