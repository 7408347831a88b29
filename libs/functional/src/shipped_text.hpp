// SPDX-License-Identifier: Apache-2.0
// The text of scenarios/task-types.yaml at build time.
#pragma once

#include <string_view>

namespace skein::functional {

std::string_view shipped_text();

}  // namespace skein::functional
