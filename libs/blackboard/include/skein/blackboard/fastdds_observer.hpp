// SPDX-License-Identifier: Apache-2.0
// Observation of a DDS domain through Fast DDS.
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

/// A participant with readers only. It discovers programs of any vendor, and reads topics of any
/// type as bytes.
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
