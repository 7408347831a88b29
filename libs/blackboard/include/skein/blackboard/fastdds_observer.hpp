// SPDX-License-Identifier: Apache-2.0
// Watching a DDS domain through Fast DDS.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "skein/blackboard/network.hpp"
#include "skein/blackboard/observer.hpp"

namespace skein::blackboard {

struct ObserverConfig {
  std::uint32_t domain = 0;              ///< 0 to 100
  std::string participant_name = "spy";  ///< shown by DDS tools
  NetworkConfig network;
};

/// One participant that has readers only. It sees what programs of any vendor say of themselves,
/// and reads any type, of which it knows no more than the bytes.
class FastDdsObserver final : public Observer {
 public:
  explicit FastDdsObserver(ObserverConfig config);
  ~FastDdsObserver() override;

  Result<void, Failure> open() override;
  Result<void, Failure> read(const Subscription& subscription) override;
  std::vector<Sighting> take() override;
  void on_sighting(std::function<void()> notify) override;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::blackboard
