// SPDX-License-Identifier: Apache-2.0
// The blackboard's transport over Cyclone DDS.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "skein/blackboard/dds_config.hpp"
#include "skein/blackboard/transport.hpp"

namespace skein::blackboard {

/// One participant over UDP in a Cyclone domain of its own, so that two transports of one process
/// use the network as those of two processes do; each channel has its own publisher and subscriber.
/// A cut deletes both; after it new ones are made, which repeat the last states and the recent
/// events. Topics, types, keys and ports are those of FastDdsTransport, and the two interoperate.
/// Samples are decoded in the middleware's threads and put into a mailbox. Destruction waits, two
/// seconds at most, until all readers have received the samples of the world channel. Environment
/// variables and files of Cyclone DDS have no effect. Supports neither security keys nor discovery
/// servers (problems_of(NetworkConfig)).
class CycloneDdsTransport final : public Transport {
 public:
  explicit CycloneDdsTransport(DdsConfig config);
  ~CycloneDdsTransport() override;

  Result<void, Failure> open(const TransportPlan& plan) override;
  bool write(std::size_t channel, const wire::Sample& sample) override;
  Result<void, Failure> set_up(std::size_t channel, bool up) override;
  std::vector<Arrival> take() override;
  void on_arrival(std::function<void()> notify) override;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::blackboard
