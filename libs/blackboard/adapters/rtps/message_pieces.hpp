// SPDX-License-Identifier: Apache-2.0
// An RTPS message in several, each of which is lost by itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace skein::blackboard::rtps {

/// Messages that together say what this one does, in its order: each has its header, and what holds
/// for what follows (INFO_DST, INFO_TS) is said again. None is longer than `longest` but for a
/// submessage that is so by itself; what is protected as one (SEC_PREFIX to SEC_POSTFIX) stays
/// together. Empty: the message fits, or goes only as it is (not understood, protected as a whole).
/// Cost: a copy. Source: RTPS 2.3, 9.4 (submessages); DDS-Security 1.1, 7.3.6.
std::vector<std::vector<std::uint8_t>> pieces_of(std::span<const std::uint8_t> message,
                                                 std::size_t longest);

}  // namespace skein::blackboard::rtps
