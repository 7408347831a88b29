// SPDX-License-Identifier: Apache-2.0
// The memory transport in virtual time.
#include <algorithm>

#include "skein/blackboard/memory_transport.hpp"
#include "testing/system.hpp"

namespace skein::blackboard::testing {
namespace {

class MemoryMedium final : public Medium {
 public:
  std::unique_ptr<Transport> transport(const std::string&) override {
    return std::make_unique<MemoryTransport>(hub_);
  }
  Duration steady() const override { return steady_; }
  void wait(Duration wakeup) override {
    steady_ = std::max(wakeup, steady_ + Duration::nanoseconds(1000));
  }

 private:
  MemoryHub hub_;
  Duration steady_;
};

}  // namespace

std::unique_ptr<Medium> make_medium() { return std::make_unique<MemoryMedium>(); }

}  // namespace skein::blackboard::testing
