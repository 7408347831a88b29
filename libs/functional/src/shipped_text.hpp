// SPDX-License-Identifier: Apache-2.0
// scenarios/task-types.yaml, as it was when this was built.
#pragma once

#include <string_view>

namespace skein::functional {

std::string_view shipped_text();

}  // namespace skein::functional
