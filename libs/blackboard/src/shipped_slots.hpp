// SPDX-License-Identifier: Apache-2.0
// scenarios/slots.yaml, as it was when this was built.
#pragma once

#include <string_view>

namespace skein::blackboard {

std::string_view shipped_slots();

}  // namespace skein::blackboard
