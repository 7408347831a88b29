// SPDX-License-Identifier: Apache-2.0
// COMETS over a radio that misbehaves: real daemons, each in a network namespace of its own, whose
// packets are cut, lost and narrowed. Nobody is told of it but by silence.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "skein/laws/healing.hpp"
#include "skein/laws/protocol.hpp"
#include "testing/lab_run.hpp"

namespace skein {
namespace {

using skein::testing::Carried;
using skein::testing::LabRun;

/// What nodes' clocks, which follow the simulator's over a network, and the logs of several processes
/// may be apart on the wall [s]: lines closer than this may come in either order (docs/journal.md).
constexpr double kApart = 0.3;

journal::Record moved(const journal::Record& record, Duration by) {
  journal::Record later(record.at() + by, record.node(), record.kind());
  for (const auto& [key, value] : record.fields()) later.with(key, value);
  return later;
}

/// Breaches of the protocol that lie further apart than that: what is sent counts as a little
/// earlier, and a link that is cut as cut a little later.
std::string breaches_of(const std::vector<journal::Record>& records, double rate) {
  const Duration apart = Duration::seconds(kApart * rate);
  std::vector<journal::Record> all = records;
  for (journal::Record& record : all) {
    const bool sent = record.text("direction") == "sent" || record.text("state") == "issued";
    const bool cut = record.kind() == "link" && !record.truth("up");
    if (sent) record = moved(record, Duration() - apart);
    if (cut) record = moved(record, apart);
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.at() < b.at(); });
  return laws::to_text(laws::broken_protocol(all));
}

/// What every run must keep, whatever its radio did.
void expect_nothing_lost_or_twice(const LabRun& run, double rate) {
  const std::vector<journal::Record> records = run.records();
  ASSERT_FALSE(records.empty());
  EXPECT_EQ(breaches_of(records, rate), "");
  laws::HealingLimits limits;
  limits.healing = Duration::seconds(3 * rate);  // three seconds of the clock on the wall
  limits.noticed = Duration::seconds(1 * rate);
  EXPECT_EQ(laws::to_text(laws::broken_healing(records, limits)), "");
}

/// Plays COMETS with the faults; skips where this machine cannot.
class Network : public ::testing::Test {
 protected:
  void play(const std::string& faults, std::vector<std::string> lab_options, double rate) {
    rate_ = rate;
    lab_options.insert(lab_options.end(), {"--", "--rate", std::to_string(static_cast<int>(rate)), "--quiet"});
    run_.start("comets/confirmed", faults, lab_options);
    const auto code = run_.wait(60 + 2100 / rate);
    ASSERT_TRUE(code.has_value()) << "no end";
    if (*code == 77) GTEST_SKIP() << run_.output();
    EXPECT_EQ(*code, 0) << run_.output();
    expect_nothing_lost_or_twice(run_, rate);
  }
  bool skipped() const { return ::testing::Test::IsSkipped(); }

  LabRun run_;
  double rate_ = 1;
};

TEST_F(Network, EndsWellWithACutInEachPhase) {
  play(R"(radio:
  cuts:
    - {between: [ground, all], from: 60, until: 70}
    - {between: [marvin, all], from: 200, until: 210}
    - {between: [heliv, all], from: 330, until: 340}
    - {between: [marvin, heliv], from: 400, until: 410}
    - {between: [ground, all], from: 600, until: 610}
)",
       {}, 10);
  if (skipped()) return;
  EXPECT_GT(run_.carried().cut, 100) << "the cuts were cuts";
}

TEST_F(Network, EndsWellWhenThreeOfTenPacketsAreLost) {
  play("", {"--loss", "0.3"}, 5);
  if (skipped()) return;
  const Carried air = run_.carried();
  EXPECT_NEAR(air.lost / (air.lost + air.carried), 0.3, 0.03);
}

TEST_F(Network, EndsWellWhenAUavIsNotHeardButHears) {
  play(R"(radio:
  cuts:
    - {between: [heliv, all], from: 250, until: 275, one_way: true}
    - {between: [ground, marvin], from: 450, until: 475, one_way: true}
)",
       {}, 5);
}

TEST_F(Network, EndsWellOnALinkThatIsUpOneSecondAndDownOne) {
  play(R"(radio:
  cuts:
    - {between: [marvin, all], from: 100, until: 250, down: 5, up: 5}
    - {between: [heliv, ground], from: 350, until: 500, down: 5, up: 5}
)",
       {}, 5);
}

TEST_F(Network, EndsWellWhenTheTeamIsSplitInTwoHalvesThatMeetAgain) {
  play(R"(radio:
  cuts:
    - {between: [[marvin, heliv], [karma, ground]], from: 300, until: 328}
)",
       {}, 5);
}

TEST_F(Network, EndsWellAfterACutOfTenSecondsOnTheWall) {
  play(R"(radio:
  cuts:
    - {between: [heliv, all], from: 300, until: 329}
    - {between: [marvin, ground], from: 480, until: 530}
)",
       {}, 3);
}

TEST_F(Network, EndsWellAtNineThousandSixHundredBitsASecond) {
  play("", {"--bits", "9600"}, 2);
}

TEST(RadioLab, LeavesNothingBehindWhenItIsKilled) {
  LabRun run;
  run.start("karma/detection", "", {"--", "--rate", "5"});
  if (!run.says("the mission starts", 60)) {
    const auto code = run.wait(1);
    if (code && *code == 77) GTEST_SKIP() << run.output();
    FAIL() << run.output();
  }
  EXPECT_GE(run.processes().size(), 5U) << "air, run, sim, ground, karma";

  run.kill();

  for (int i = 0; i < 100 && !run.processes().empty(); ++i) usleep(50'000);
  EXPECT_TRUE(run.processes().empty());
  EXPECT_FALSE(std::filesystem::exists("/run/netns/karma"));
}

TEST(RadioLab, SaysWhatIsWrongWithItsOptions) {
  LabRun run;
  run.start("karma/detection", "radio: {lss: 0.3}\n", {});
  const auto code = run.wait(60);
  if (code && *code == 77) GTEST_SKIP() << run.output();
  EXPECT_EQ(code, 2);
  EXPECT_NE(run.output().find("did you mean 'loss'"), std::string::npos) << run.output();
}

}  // namespace
}  // namespace skein
