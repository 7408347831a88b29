// SPDX-License-Identifier: Apache-2.0
// Whole files as text.
#pragma once

#include <iosfwd>
#include <string>

#include "skein/foundation/result.hpp"

namespace skein::plan_tool {

/// "-" is the stream. What is no file, or cannot be read, is a failure.
Result<std::string, Failure> text_of_file(const std::string& file, std::istream& in);

}  // namespace skein::plan_tool
