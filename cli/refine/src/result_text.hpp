// SPDX-License-Identifier: Apache-2.0
// An answer for people.
#pragma once

#include <iosfwd>

#include "answer.hpp"

namespace skein::refine_tool {

void write_text(std::ostream& out, const Query& query, const Answer& answer, bool colour);

}  // namespace skein::refine_tool
