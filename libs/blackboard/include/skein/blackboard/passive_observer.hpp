// SPDX-License-Identifier: Apache-2.0
// Observation of a DDS domain by packet capture, without readers.
#pragma once

#include <memory>

#include "skein/blackboard/fastdds_observer.hpp"

namespace skein::blackboard {

/// Discovery works as in FastDdsObserver. Samples are captured as they pass the interfaces of this
/// machine on their way to other programs: the kernel copies each datagram once, and writers and
/// readers have no extra work. So samples are seen only if some reader gets them, if they cross
/// this machine, and if they are sent after read(). Needs CAP_NET_RAW. Cannot read secured domains:
/// with keys open() fails. on_sighting() reports discovery only; samples are there at the next
/// take(). take() has to be called at least once a second.
class PassiveObserver final : public Observer {
 public:
  explicit PassiveObserver(ObserverConfig config);
  ~PassiveObserver() override;

  Result<void, Failure> open() override;
  Result<void, Failure> read(const Subscription& subscription) override;
  std::vector<Sighting> take() override;
  void on_sighting(std::function<void()> notify) override;
  /// Number of datagrams that were dropped because the capture was overloaded.
  std::uint64_t lost() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::blackboard
