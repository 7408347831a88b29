// SPDX-License-Identifier: Apache-2.0
#include "bounded_call.hpp"

#include <chrono>
#include <future>
#include <thread>
#include <utility>

namespace skein::blackboard::cyclonedds {

bool returns_within(Duration limit, std::function<void()> call) {
  std::promise<void> returned;
  const std::future<void> end = returned.get_future();
  std::thread([call = std::move(call), returned = std::move(returned)]() mutable {
    call();
    returned.set_value();
  }).detach();
  return end.wait_for(std::chrono::nanoseconds(limit.count())) == std::future_status::ready;
}

}  // namespace skein::blackboard::cyclonedds
