// SPDX-License-Identifier: Apache-2.0
// The configuration of a Cyclone DDS domain.
#pragma once

#include <cstdint>
#include <string>

#include "adapters/rtps/pace.hpp"
#include "skein/blackboard/dds_config.hpp"

namespace skein::blackboard::cyclonedds {

/// As XML: the interfaces of `config` only, discovery as configured there and with the ports of
/// participant `number`, as Fast DDS has them. For dds_create_domain(), which then reads neither
/// file nor environment (CYCLONEDDS_URI).
std::string settings(const DdsConfig& config, std::uint32_t number, const rtps::Pace& pace = {});

}  // namespace skein::blackboard::cyclonedds
