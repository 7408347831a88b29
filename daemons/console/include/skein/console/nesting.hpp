// SPDX-License-Identifier: Apache-2.0
// How deep JSON from outside may be nested.
#pragma once

#include <string>

namespace skein::console {

/// Whether the JSON is nested deeper than 64 lists and objects, which nothing is that is meant
/// well: who reads, copies or writes it would go as deep, on the stack. Need not be JSON.
bool is_too_deep(const std::string& text);

}  // namespace skein::console
