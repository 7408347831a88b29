// SPDX-License-Identifier: Apache-2.0
// The blackboard's transport over the configured DDS.
#pragma once

#include <memory>

#include "skein/blackboard/dds_config.hpp"
#include "skein/blackboard/transport.hpp"

namespace skein::blackboard {

/// A transport of the vendor `config.network.dds`.
std::unique_ptr<Transport> make_dds_transport(DdsConfig config);

}  // namespace skein::blackboard
