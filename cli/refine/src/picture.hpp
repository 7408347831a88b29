// SPDX-License-Identifier: Apache-2.0
// An answer as a picture.
#pragma once

#include <string>

#include "answer.hpp"

namespace skein::refine_tool {

/// SVG.
std::string picture_of(const Query& query, const Answer& answer);

}  // namespace skein::refine_tool
