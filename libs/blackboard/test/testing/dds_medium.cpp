// SPDX-License-Identifier: Apache-2.0
// DDS on the loopback interface, in a domain of its own. SKEIN_MEDIUM says who is on which.
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>

#include "skein/blackboard/dds_transport.hpp"
#include "skein/blackboard/domain_lease.hpp"
#include "testing/discovery_server.hpp"
#include "testing/system.hpp"

namespace skein::blackboard::testing {
namespace {

constexpr std::string_view kMedium = SKEIN_MEDIUM;
constexpr bool kServer = kMedium == "discovery_server";

DdsVendor vendor_of(const std::string& node) {
  if (kServer) return DdsVendor::kFastDds;
  if (const auto all = dds_from_name(kMedium)) return *all;
  const bool ground = node == kGround.name;
  const bool cyclone = kMedium == "ground_on_cyclonedds" ? ground : !ground;
  return cyclone ? DdsVendor::kCycloneDds : DdsVendor::kFastDds;
}

class DdsMedium final : public Medium {
 public:
  DdsMedium() {
    if (kServer) server_.emplace(lease_.value().domain());
  }
  std::unique_ptr<Transport> transport(const std::string& node) override {
    DdsConfig config;
    config.domain = lease_.value().domain();
    config.participant_name = node;
    config.network.dds = vendor_of(node);
    if (server_) config.network.discovery_servers = {server_->address()};
    auto made = make_dds_transport(std::move(config));
    made->on_arrival([this] {
      const std::lock_guard lock(mutex_);
      arrived_ = true;
      wake_.notify_one();
    });
    return made;
  }
  Duration steady() const override {
    const auto since = std::chrono::steady_clock::now() - start_;
    return Duration::nanoseconds(std::chrono::nanoseconds(since).count());
  }
  void wait(Duration wakeup) override {
    std::unique_lock lock(mutex_);
    const auto until = start_ + std::chrono::nanoseconds(wakeup.count());
    wake_.wait_until(lock, until, [this] { return arrived_; });
    arrived_ = false;
  }

 private:
  Result<DomainLease, Failure> lease_ = claim_domain();
  std::optional<DiscoveryServer> server_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::condition_variable wake_;
  bool arrived_ = false;
};

}  // namespace

std::unique_ptr<Medium> make_medium() { return std::make_unique<DdsMedium>(); }

}  // namespace skein::blackboard::testing
