// SPDX-License-Identifier: Apache-2.0
// A participant with valid keys that says it is another node. Its own DDS would not stop it on the
// world channel, where everybody writes: the blackboard's transport does (docs/threats.md).
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <condition_variable>
#include <cstdlib>
#include <filesystem>
#include <mutex>

#include "skein/blackboard/domain_lease.hpp"
#include "skein/blackboard/fastdds_transport.hpp"

namespace skein::blackboard {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr NodeNumber kGround{1};
constexpr NodeNumber kMarvin{10};
constexpr NodeNumber kHeliv{11};

/// Keys of the COMETS nodes, made as a user makes them.
class Secured : public ::testing::Test {
 protected:
  Secured() : keys_(fs::temp_directory_path() / ("skein-keys-" + std::to_string(getpid()))) {
    const std::string command = SKEIN_SOURCE_DIR "/scripts/make-keys " + keys_.string() + " " +
                                SKEIN_SOURCE_DIR "/scenarios/comets/confirmed.yaml --programs " +
                                SKEIN_BINARY_DIR "/bin >/dev/null";
    made_ = std::system(command.c_str()) == 0;  // NOLINT(concurrency-mt-unsafe): one thread
  }
  ~Secured() override { fs::remove_all(keys_); }

  /// With the keys of `name`, but saying that it is the node `self`; it writes on the world channel
  /// what the permissions of a UAV allow.
  std::unique_ptr<FastDdsTransport> participant(const std::string& name, NodeNumber self) {
    DdsConfig config;
    config.domain = lease_->domain();
    config.participant_name = name;
    config.network.keys = (keys_ / name).string();
    config.names = {{kGround, "ground"}, {kMarvin, "marvin"}, {kHeliv, "heliv"}};
    auto made = std::make_unique<FastDdsTransport>(std::move(config));
    made->on_arrival([this] {
      const std::lock_guard lock(mutex_);
      arrived_ = true;
      wake_.notify_one();
    });
    TransportPlan plan;
    plan.self = self;
    plan.channels = {world_channel()};
    plan.channels[0].slots = {wire::Slot::kJournalEntry};
    if (name == "runner") {
      plan.channels[0].slots.clear();
      plan.world_reads = {wire::Slot::kJournalEntry};
    }
    const auto opened = made->open(plan);
    EXPECT_TRUE(opened.has_value()) << opened.error().why;
    return made;
  }

  static wire::JournalEntry said_by(NodeNumber origin) {
    wire::JournalEntry entry;
    entry.header.origin = origin.value();
    entry.header.incarnation = 1;
    entry.header.sequence_number = 1;
    entry.record = "{}";
    return entry;
  }

  /// The next arrival, within a generous time.
  std::optional<Arrival> next(FastDdsTransport& transport) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (true) {
      std::vector<Arrival> all = transport.take();
      if (!all.empty()) return all.front();
      std::unique_lock lock(mutex_);
      if (!wake_.wait_until(lock, until, [this] { return arrived_; })) return std::nullopt;
      arrived_ = false;
    }
  }

  bool made_ = false;

 private:
  fs::path keys_;
  Result<DomainLease, Failure> lease_ = claim_domain();
  std::mutex mutex_;
  std::condition_variable wake_;
  bool arrived_ = false;
};

TEST_F(Secured, WhatANodeSaysOfItselfArrives) {
  ASSERT_TRUE(made_);
  const auto reader = participant("runner", NodeNumber(3));
  const auto heliv = participant("heliv", kHeliv);

  ASSERT_TRUE(heliv->write(0, said_by(kHeliv)));

  const auto arrival = next(*reader);
  ASSERT_TRUE(arrival.has_value());
  EXPECT_TRUE(std::holds_alternative<wire::Sample>(arrival->content));
}

TEST_F(Secured, WhatANodeSaysInTheNameOfAnotherIsMalformed) {
  ASSERT_TRUE(made_);
  const auto reader = participant("runner", NodeNumber(3));
  const auto impostor = participant("heliv", kMarvin);

  ASSERT_TRUE(impostor->write(0, said_by(kMarvin)));

  const auto arrival = next(*reader);
  ASSERT_TRUE(arrival.has_value());
  const auto* malformed = std::get_if<Malformed>(&arrival->content);
  ASSERT_NE(malformed, nullptr);
  EXPECT_EQ(malformed->header.origin, 0U);  // it has no place in anybody's session
  EXPECT_THAT(malformed->violation.why, HasSubstr("marvin did not write this"));
}

TEST_F(Secured, WhatAStrangerSaysIsMalformed) {
  ASSERT_TRUE(made_);
  const auto reader = participant("runner", NodeNumber(3));
  const auto stranger = participant("heliv", NodeNumber(77));

  ASSERT_TRUE(stranger->write(0, said_by(NodeNumber(77))));

  const auto arrival = next(*reader);
  ASSERT_TRUE(arrival.has_value());
  EXPECT_TRUE(std::holds_alternative<Malformed>(arrival->content));
}

}  // namespace
}  // namespace skein::blackboard
