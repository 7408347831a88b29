// SPDX-License-Identifier: Apache-2.0
// A discovery server of Fast DDS in this process, as `fastdds discovery --server-id 0` is one.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace skein::blackboard::testing {

class DiscoveryServer {
 public:
  /// On a port of that domain which no participant of ours takes.
  explicit DiscoveryServer(std::uint32_t domain);
  ~DiscoveryServer();
  /// "127.0.0.1:7600".
  const std::string& address() const { return address_; }

 private:
  class Impl;
  std::string address_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::blackboard::testing
