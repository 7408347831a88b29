// SPDX-License-Identifier: Apache-2.0
// Numbers as text, for files.
#pragma once

#include <string>

namespace skein {

/// The shortest decimal text that reads back as the same number; "0" for both zeros, "inf", "nan".
std::string shortest_text(double number);

}  // namespace skein
