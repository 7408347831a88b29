// SPDX-License-Identifier: Apache-2.0
// Recorded on one domain, played on another: the same samples, byte for byte.
#include "skein/spy_tool/record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <thread>

#include "recorder.hpp"
#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/domain_lease.hpp"
#include "skein/blackboard/fastdds_transport.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/node/roster.hpp"
#include "skein/node/waker.hpp"
#include "temporary_folder.hpp"

namespace skein::spy_tool {
namespace {

using blackboard::Now;
using ::testing::HasSubstr;

Now now() { return {{}, node::Waker::steady_now()}; }

/// A ground station that says some things, as a daemon would.
class Ground {
 public:
  explicit Ground(std::uint32_t domain)
      : transport_(blackboard::DdsConfig{domain, "ground", {}, {}}) {
    const node::Roster roster({"marvin"});
    blackboard::Config config;
    config.self = roster.ground();
    config.channels = roster.channels_of(*roster.find("ground"));
    auto board = blackboard::Blackboard::open(config, transport_);
    if (!board) throw std::runtime_error(board.error().why);
    board_.emplace(std::move(*board));
  }
  void say() {
    wire::DirectoryEntry entry;
    entry.name = "ground";
    entry.role = wire::Role::kGround;
    EXPECT_TRUE(board_->publish(entry, now()).has_value());
    for (const char* name : {"Detection", "Monitoring"}) {
      wire::MissionState state;
      state.phase = name;
      EXPECT_TRUE(board_->publish(state, now()).has_value());
    }
  }

 private:
  blackboard::FastDdsTransport transport_;
  std::optional<blackboard::Blackboard> board_;
};

/// Domains of this test's own, and files.
class RecordAndPlay : public ::testing::Test {
 protected:
  void SetUp() override {
    for (int i = 0; i < 2; ++i) {
      auto lease = blackboard::claim_domain();
      ASSERT_TRUE(lease.has_value()) << lease.error().why;
      leases_.push_back(std::move(*lease));
    }
  }
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }

  RecordOptions recording(std::size_t lease, const std::string& name, std::uint64_t count) const {
    RecordOptions options;
    options.spy.domain = leases_[lease].domain();
    options.spy.slots = {"DirectoryEntry", "MissionState"};
    options.spy.count = count;
    options.spy.duration = 30;
    options.file = file(name);
    return options;
  }

  static std::vector<Taken> samples(const std::string& name) {
    std::ifstream in(name, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    std::vector<Taken> all;
    samples_of(bytes, [&](Taken one) {
      one.heard = one.sent = 0;
      all.push_back(std::move(one));
    });
    std::sort(all.begin(), all.end(), [](const Taken& a, const Taken& b) {
      return std::tie(a.slot, a.partition, a.bytes) < std::tie(b.slot, b.partition, b.bytes);
    });
    return all;
  }

  skein::testing::TemporaryFolder folder_;
  std::vector<blackboard::DomainLease> leases_;
  std::ostringstream out_, err_;
};

TEST_F(RecordAndPlay, GivesTheSameSamplesOnAnotherDomain) {
  Ground ground(leases_[0].domain());
  ground.say();  // states: they are told to whoever comes late
  ASSERT_EQ(record(recording(0, "first.mcap", 2), out_, err_), kExitOk) << err_.str();
  const auto first = samples(file("first.mcap"));
  ASSERT_EQ(first.size(), 2U);
  EXPECT_EQ(first[0].partition, "world");

  std::ostringstream out, err;
  std::thread recorder([&] { record(recording(1, "second.mcap", 2), out, err); });
  PlayOptions options;
  options.domain = leases_[1].domain();
  options.file = file("first.mcap");
  EXPECT_EQ(play(options, out_, err_), kExitOk) << err_.str();
  recorder.join();

  EXPECT_EQ(samples(file("second.mcap")), first) << err.str();
  EXPECT_THAT(out_.str(), HasSubstr("2 of 2 samples written"));
}

TEST_F(RecordAndPlay, OfADomainWhereNobodyIsSaysSo) {
  RecordOptions options = recording(0, "none.mcap", 1);
  options.spy.duration = 0.5;

  EXPECT_EQ(record(options, out_, err_), kExitTimeout);
  EXPECT_THAT(err_.str(), HasSubstr("nothing heard"));
}

TEST_F(RecordAndPlay, SaysOfWhatCannotBeReadThatItCannot) {
  for (const std::string& name : {folder_.path().string(), file("nothing.mcap")}) {
    PlayOptions options;
    options.file = name;
    EXPECT_EQ(play(options, out_, err_), kExitBadInput);
    EXPECT_THAT(err_.str(), HasSubstr(name + ": cannot be read"));
  }
}

TEST_F(RecordAndPlay, RefusesWhatIsNoRecording) {
  std::ofstream(file("text.mcap")) << "no recording";
  PlayOptions options;
  options.domain = leases_[0].domain();
  options.file = file("text.mcap");

  EXPECT_EQ(play(options, out_, err_), kExitBadInput);
  EXPECT_THAT(err_.str(), HasSubstr("does not begin as an MCAP file"));
  options.file = file("none.mcap");
  EXPECT_EQ(play(options, out_, err_), kExitBadInput);
}

TEST_F(RecordAndPlay, SaysWhatItCannotWrite) {
  RecordOptions options = recording(0, "x.mcap", 1);
  options.file = "/no/such/folder/x.mcap";

  EXPECT_EQ(record(options, out_, err_), kExitSystem);
}

}  // namespace
}  // namespace skein::spy_tool
