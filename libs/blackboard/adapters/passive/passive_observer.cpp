// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/passive_observer.hpp"

#include <chrono>
#include <utility>

#include "adapters/passive/capture.hpp"
#include "adapters/passive/packet_ring.hpp"
#include "adapters/rtps/ports.hpp"

namespace skein::blackboard {

class PassiveObserver::Impl {
 public:
  explicit Impl(ObserverConfig config) : config_(config), discovery_(std::move(config)) {}

  Result<void, Failure> open() {
    if (!config_.network.keys.empty())
      return failure("what is protected by keys cannot be seen as it passes");
    const unsigned first = rtps::first_port(config_.domain);
    for (const std::string& address : config_.network.interfaces) {
      auto ring = passive::PacketRing::open(address, first, first + rtps::kPortsPerDomain - 1);
      if (!ring) return tl::unexpected(ring.error());
      rings_.push_back(std::move(*ring));
    }
    return discovery_.open();
  }
  Observer& discovery() { return discovery_; }
  void read(const Subscription& subscription) { capture_.read(subscription); }

  std::vector<Sighting> take() {
    std::vector<Sighting> sightings = discovery_.take();
    for (const Sighting& one : sightings) capture_.note(one);
    lost_ = 0;
    for (passive::PacketRing& ring : rings_) {
      ring.take([this](auto datagram, std::int64_t heard) { capture_.take(datagram, heard); });
      lost_ += ring.lost();
    }
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    for (SampleSeen& sample :
         capture_.turn(Duration::nanoseconds(std::chrono::nanoseconds(now).count())))
      sightings.emplace_back(std::move(sample));
    return sightings;
  }
  std::uint64_t lost() const { return lost_; }

 private:
  ObserverConfig config_;
  FastDdsObserver discovery_;
  std::vector<passive::PacketRing> rings_;
  passive::Capture capture_;
  std::uint64_t lost_ = 0;
};

PassiveObserver::PassiveObserver(ObserverConfig config)
    : impl_(std::make_unique<Impl>(std::move(config))) {}
PassiveObserver::~PassiveObserver() = default;

Result<void, Failure> PassiveObserver::open() { return impl_->open(); }

Result<void, Failure> PassiveObserver::read(const Subscription& subscription) {
  impl_->read(subscription);
  return {};
}

std::vector<Sighting> PassiveObserver::take() { return impl_->take(); }

void PassiveObserver::on_sighting(std::function<void()> notify) {
  impl_->discovery().on_sighting(std::move(notify));
}

std::uint64_t PassiveObserver::lost() const { return impl_->lost(); }

}  // namespace skein::blackboard
