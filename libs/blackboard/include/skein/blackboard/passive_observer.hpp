// SPDX-License-Identifier: Apache-2.0
// Watching a DDS domain without reading in it.
#pragma once

#include <memory>

#include "skein/blackboard/fastdds_observer.hpp"

namespace skein::blackboard {

/// Discovery as FastDdsObserver sees it; samples are not sent to it, but seen as they pass the
/// interfaces of this machine on their way to others: the kernel copies each datagram once, writers
/// and readers do nothing for it. So it sees what is said while it looks, and nothing that was said
/// before; nothing that nobody else reads; of another machine's what comes here. It needs
/// CAP_NET_RAW, and sees nothing of what is protected by keys: with keys open() fails. on_sighting
/// tells of discovery only: samples are there at the next take(). At least one take() a second.
class PassiveObserver final : public Observer {
 public:
  explicit PassiveObserver(ObserverConfig config);
  ~PassiveObserver() override;

  Result<void, Failure> open() override;
  Result<void, Failure> read(const Subscription& subscription) override;
  std::vector<Sighting> take() override;
  void on_sighting(std::function<void()> notify) override;
  /// Datagrams that passed and were not seen, since there was too much at once.
  std::uint64_t lost() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::blackboard
