// SPDX-License-Identifier: Apache-2.0
// How several agents keep their networks consistent with each other.
#pragma once

#include <cstdint>
#include <string>

namespace skein::temporal {

/// What an agent knows and sends: table of spec 5.3. Source: M 3.
enum class Algorithm : std::uint8_t { kCip, kDipG, kDipL, kDipM };
/// "CIP", "DIP-G", …
std::string to_text(Algorithm algorithm);

}  // namespace skein::temporal
