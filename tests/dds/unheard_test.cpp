// SPDX-License-Identifier: Apache-2.0
// Daemons that the runner does not hear: it says so, and no records are missing in silence.
#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <set>

#include "skein/blackboard/domain_lease.hpp"
#include "skein/journal/line.hpp"
#include "skein/journal/lines/radio.hpp"
#include "testing/dds_run.hpp"

namespace skein::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kLibrary = SKEIN_BINARY_DIR "/lib/libskein_adversity.so";
constexpr const char* kAnew = "nothing is heard of karma; listening anew";

/// For karma the command with `changed`, for the others as it is.
std::string of_karma(const std::string& changed) {
  return "case \"$*\" in *'--uav karma'*) " + changed +
         " ;; esac\nexec \"$programs/skein-ddn\" \"$@\"";
}

// The runner comes first, so it is participant 0; five daemons later the next one is number 6.
std::string mute_to(const std::string& participants) {
  return of_karma("export ADVERSITY_MUTE=" + participants + " LD_PRELOAD='" + kLibrary + "'");
}

std::size_t records_of_karma(const DdsRun& run) {
  std::size_t count = 0;
  for (const journal::Record& record : run.records()) count += record.node() == "karma" ? 1 : 0;
  return count;
}

std::optional<journal::lines::Reach> contact_of(const journal::Record& record) {
  if (record.kind() != journal::lines::Reach::kKind) return std::nullopt;
  return journal::read_as<journal::lines::Reach>(record);
}

/// Of two sightings that arrive in one turn the ground station says the same; that they are two is
/// in the numbers of their messages.
bool says_nothing_of_its_own(const journal::Record& record) {
  return record.kind() == "process" || record.kind() == "telemetry" ||
         record.kind() == "perception";
}

/// Records that came twice. Contact may be lost and found again in one instant, before the mission
/// starts above all: of it twice the same, with nothing else about those two between, is twice.
std::size_t records_twice(const std::vector<journal::Record>& records) {
  std::set<std::string> said;
  std::map<std::string, std::string> last_contact;
  std::size_t twice = 0;
  for (const journal::Record& record : records) {
    if (says_nothing_of_its_own(record)) continue;
    const std::string text = journal::to_json(record);
    if (const auto contact = contact_of(record)) {
      std::string& last = last_contact[record.node() + " " + std::string(contact->peer)];
      twice += last == text ? 1 : 0;
      last = text;
    } else {
      twice += said.insert(text).second ? 0 : 1;
    }
  }
  return twice;
}

class DdsUnheard : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(kLibrary)) GTEST_SKIP() << "not with sanitizers";
    run.take_scenario("confirmed");
  }

  DdsRun run;
};

TEST_F(DdsUnheard, ADaemonThatOnlyAnotherParticipantHearsIsHeardAnewWithItsRecordsFromTheStart) {
  run.start({"--rate", "20", "--daemons", run.programs_with({"skein-ddn"}, mute_to("0"))});
  run.wait_for_output(kAnew);
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 0) << run.output();
  const auto records = run.records();
  EXPECT_TRUE(std::any_of(records.begin(), records.end(), [](const journal::Record& record) {
    return record.node() == "karma" && record.at() < MissionTime::seconds(5);
  }));
  EXPECT_EQ(records_twice(records), 0U);
  EXPECT_TRUE(run.nothing_runs());
}

TEST_F(DdsUnheard, ADaemonThatIsNotHeardAnewEitherEndsTheRunWithFourAndItsName) {
  run.start({"--rate", "20", "--daemons", run.programs_with({"skein-ddn"}, mute_to("0,6"))});
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 4);
  EXPECT_THAT(run.output(), AllOf(HasSubstr(kAnew), HasSubstr("nothing is heard of karma, who")));
  EXPECT_EQ(records_of_karma(run), 0U);
  EXPECT_TRUE(run.nothing_runs());
}

TEST_F(DdsUnheard, AMissionThatIsOverBeforeThatEndsWithFourToo) {
  run.change("duration_limit: ", "duration_limit: 60  # ");
  run.start({"--rate", "20", "--daemons", run.programs_with({"skein-ddn"}, mute_to("0"))});
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 4);
  EXPECT_THAT(run.output(), AllOf(HasSubstr("nothing was heard of karma"), Not(HasSubstr(kAnew))));
}

TEST_F(DdsUnheard, ADaemonOnAnotherDomainEndsTheRunWithFourAndItsName) {
  const auto lease = blackboard::claim_domain();  // the next number may be another test's
  ASSERT_TRUE(lease.has_value());
  const std::string other =
      "for one; do shift; [ \"$before\" != --domain ] || one=" + std::to_string(lease->domain()) +
      "; set -- \"$@\" \"$one\"; before=$one; done";
  run.start({"--daemons", run.programs_with({"skein-ddn"}, of_karma(other))});
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 4);
  EXPECT_THAT(run.output(), HasSubstr(" s: karma, of whom nothing is heard; waiting: sim, ground"));
  EXPECT_TRUE(run.nothing_runs());
}

// Its keys are of another authority, so no handshake with it ends.
TEST_F(DdsUnheard, ADaemonWhoseHandshakesFailEndsTheRunWithFourAndItsName) {
  const std::string make = std::string(SKEIN_SOURCE_DIR) + "/scripts/make-keys";
  const std::string scenario = run.file("scenario.yaml").string();
  for (const char* folder : {"keys", "others"}) {
    const std::string command = make + " '" + run.file(folder).string() + "' '" + scenario +
                                "' --programs '" + kPrograms + "' > /dev/null";
    ASSERT_EQ(std::system(command.c_str()), 0);  // NOLINT: of this test's own words
  }
  const std::string other = "for one; do shift; [ \"$before\" != --security ] || one='" +
                            run.file("others").string() +
                            "'; set -- \"$@\" \"$one\"; before=$one; done";
  run.start({"--security", run.file("keys").string(), "--daemons",
             run.programs_with({"skein-ddn"}, of_karma(other))});
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 4);
  EXPECT_THAT(run.output(), HasSubstr(" s: karma, of whom nothing is heard; waiting: sim, ground"));
  EXPECT_TRUE(run.nothing_runs());
}

}  // namespace
}  // namespace skein::testing
