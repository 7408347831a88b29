// SPDX-License-Identifier: Apache-2.0
// Fast DDS on the loopback interface, in a domain of its own.
#include <chrono>
#include <condition_variable>
#include <mutex>

#include "skein/blackboard/domain_lease.hpp"
#include "skein/blackboard/fastdds_transport.hpp"
#include "testing/system.hpp"

namespace skein::blackboard::testing {
namespace {

class FastDdsMedium final : public Medium {
 public:
  std::unique_ptr<Transport> transport(const std::string& node) override {
    FastDdsConfig config;
    config.domain = lease_.value().domain();
    config.participant_name = node;
    auto made = std::make_unique<FastDdsTransport>(std::move(config));
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
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::condition_variable wake_;
  bool arrived_ = false;
};

}  // namespace

std::unique_ptr<Medium> make_medium() { return std::make_unique<FastDdsMedium>(); }

}  // namespace skein::blackboard::testing
