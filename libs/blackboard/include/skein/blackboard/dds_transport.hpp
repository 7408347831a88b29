// SPDX-License-Identifier: Apache-2.0
// The blackboard's transport over the DDS that was chosen.
#pragma once

#include <memory>

#include "skein/blackboard/dds_config.hpp"
#include "skein/blackboard/transport.hpp"

namespace skein::blackboard {

/// Of the vendor that config.network.dds names.
std::unique_ptr<Transport> make_dds_transport(DdsConfig config);

}  // namespace skein::blackboard
