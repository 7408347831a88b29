// SPDX-License-Identifier: Apache-2.0
// What the laws of the blackboard are told with: nodes, what they say, and what came of it.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "testing/samples.hpp"
#include "testing/system.hpp"

namespace skein::blackboard::testing {

class BlackboardLaws : public ::testing::Test {
 protected:
  void start_pair() {
    system.start(kGround);
    system.start(kMarvin);
    ASSERT_TRUE(system.run_until_reachable(kGround, kMarvin));
  }
  void send(const Node& from, const Node& to, wire::Sample sample, SendOptions options = {}) {
    ASSERT_TRUE(system[from].send(std::move(sample), to.number, system.now(), options));
  }
  std::vector<std::uint64_t> events(const Node& node) {
    std::vector<std::uint64_t> ids;
    for (const Incoming& incoming : system.received(node)) {
      const auto* received = std::get_if<Received>(&incoming);
      if (received == nullptr) continue;
      if (const auto* event = std::get_if<wire::TaskEvent>(&received->sample)) {
        ids.push_back(event->id);
      } else if (const auto* sync = std::get_if<wire::SyncMessage>(&received->sample)) {
        ids.push_back(sync->id);
      }
    }
    return ids;
  }
  bool run_until_events(const Node& node, std::size_t count) {
    return system.run_until([&, count] { return events(node).size() >= count; });
  }
  /// Long enough for anything that is still under way to arrive: a full exchange after it.
  void settle() {
    send(kMarvin, kGround, sync_message(900));
    ASSERT_TRUE(system.run_until([&] {
      const auto ids = events(kGround);
      return !ids.empty() && ids.back() == 900 &&
             system[kMarvin].unacknowledged(kGround.number) == 0;
    }));
  }

  System system;
};

}  // namespace skein::blackboard::testing
