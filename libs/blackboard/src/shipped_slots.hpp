// SPDX-License-Identifier: Apache-2.0
// The text of scenarios/slots.yaml at build time.
#pragma once

#include <string_view>

namespace skein::blackboard {

std::string_view shipped_slots();

}  // namespace skein::blackboard
