// SPDX-License-Identifier: Apache-2.0
// What participants say when they leave.
#pragma once

#include <cstdint>
#include <span>

namespace skein::blackboard::rtps {

/// Whether an RTPS message says that a participant leaves its domain: DATA of the writer of
/// participants' announcements that disposes of its sample or unregisters it, by its QoS or by
/// having no content. False for what is cut short before. Source: RTPS 2.3, 8.5.3, 9.4.5.3 and
/// 9.6.3.9. Cost: linear in the message.
bool tells_departure(std::span<const std::uint8_t> message);

}  // namespace skein::blackboard::rtps
