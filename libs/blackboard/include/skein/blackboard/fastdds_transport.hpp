// SPDX-License-Identifier: Apache-2.0
// The blackboard's transport over Fast DDS.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "skein/blackboard/dds_config.hpp"
#include "skein/blackboard/transport.hpp"

namespace skein::blackboard {

/// One participant over UDP; each channel has its own publisher and subscriber. A cut deletes
/// both; after it new ones are made, which repeat the last states and the recent events
/// (docs/decisions/0022). Topics are named after the slots, types are those of idl/. Samples are
/// decoded in the middleware's threads and put into a mailbox. Destruction waits, two seconds at
/// most, until all readers have received the samples of the world channel. Environment variables
/// and profile files of Fast DDS have no effect.
class FastDdsTransport final : public Transport {
 public:
  explicit FastDdsTransport(DdsConfig config);
  ~FastDdsTransport() override;

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
