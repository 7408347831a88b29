// SPDX-License-Identifier: Apache-2.0
// The blackboard's transport over the DDS that was chosen.
#include "skein/blackboard/dds_transport.hpp"

#include <utility>

#include "skein/blackboard/cyclonedds_transport.hpp"
#include "skein/blackboard/fastdds_transport.hpp"

namespace skein::blackboard {

std::unique_ptr<Transport> make_dds_transport(DdsConfig config) {
  if (config.network.dds == DdsVendor::kCycloneDds) {
    return std::make_unique<CycloneDdsTransport>(std::move(config));
  }
  return std::make_unique<FastDdsTransport>(std::move(config));
}

}  // namespace skein::blackboard
