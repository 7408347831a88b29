// SPDX-License-Identifier: Apache-2.0
// Hexadecimal text of bytes of unknown format.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace skein::spy_tool {

/// Two digits for each.
std::string hexadecimal(std::span<const std::uint8_t> bytes);
/// Sixteen a line, with their place before and as text behind; at most 256, and how many more
/// there are.
std::string hexadecimal_lines(std::span<const std::uint8_t> bytes);

}  // namespace skein::spy_tool
