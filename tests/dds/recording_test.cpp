// SPDX-License-Identifier: Apache-2.0
// A mission recorded twice at once: by a reader, and by what passes the interface.
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>

#include "recorder.hpp"
#include "skein/foundation/exit_code.hpp"
#include "testing/dds_run.hpp"

namespace skein::testing {
namespace {

using spy_tool::Taken;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::uint64_t kSecond = 1'000'000'000;

std::vector<Taken> samples_in(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  std::vector<Taken> samples;
  spy_tool::samples_of(bytes, [&](Taken one) { samples.push_back(std::move(one)); });
  return samples;
}

/// By slot and content, which names origin and number. Heard within these instants.
using Said = std::map<std::pair<wire::Slot, std::string>, std::string>;  ///< partition
Said said_between(const std::vector<Taken>& samples, std::uint64_t from, std::uint64_t to) {
  Said said;
  for (const Taken& one : samples)
    if (one.heard >= from && one.heard < to)
      said.emplace(std::pair(one.slot, one.bytes), one.partition);
  return said;
}

class TwoRecordings : public ::testing::TestWithParam<const char*> {
 protected:
  run_tool::Process recorder(const std::string& name, const std::vector<std::string>& more) const {
    std::vector<std::string> words{
        kPrograms + "/skein", "spy", "--domain", domain_,
        "--duration",         "8",   "record",   run_.file(name).string()};
    words.insert(words.end(), more.begin(), more.end());
    return std::move(*run_tool::Process::start(words, run_.file(name + ".log").string()));
  }
  std::string text_of(const std::string& name) const {
    std::ifstream in(run_.file(name));
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void start_mission() {
    run_.take_scenario("confirmed", GetParam());
    run_.start({"--rate", "10"});
    run_.wait_for_output("the mission starts");
    const std::string output = run_.output(), before = "on DDS domain ";
    domain_ = std::to_string(std::stoi(output.substr(output.find(before) + before.size())));
  }

  DdsRun run_;
  std::string domain_;
};

TEST_P(TwoRecordings, HaveTheSameSamples) {
  start_mission();
  run_tool::Process reader = recorder("reader.mcap", {});
  run_tool::Process passive = recorder("passive.mcap", {"--passive"});
  ASSERT_TRUE(holds_within(60, [&] { return reader.poll() && passive.poll(); }));
  if (passive.poll()->code == kExitSystem) GTEST_SKIP() << text_of("passive.mcap.log");
  ASSERT_EQ(passive.poll()->code, 0) << text_of("passive.mcap.log");
  ASSERT_THAT(text_of("passive.mcap.log"), ::testing::Not(HasSubstr("too fast")));

  const auto by_reader = samples_in(run_.file("reader.mcap"));
  const auto as_passed = samples_in(run_.file("passive.mcap"));
  ASSERT_FALSE(by_reader.empty() || as_passed.empty());
  // A reader comes to know all writers within a second or two.
  const std::uint64_t from =
      std::max(by_reader.front().heard, as_passed.front().heard) + 3 * kSecond;
  const std::uint64_t to = std::min(by_reader.back().heard, as_passed.back().heard) - kSecond;
  const Said read = said_between(by_reader, from, to);
  const Said passed = said_between(as_passed, from - kSecond, to + kSecond);
  EXPECT_GT(read.size(), 100U);
  for (const auto& [what, partition] : read) {
    const auto found = passed.find(what);
    ASSERT_NE(found, passed.end()) << wire::slot_name(what.first) << " in " << partition;
    EXPECT_EQ(found->second, partition);
  }
  // Streams are best effort: a reader on a loaded machine may miss what passes.
  const Said all_read = said_between(by_reader, 0, to + 10 * kSecond);
  for (const auto& [what, partition] : said_between(as_passed, from, to))
    EXPECT_TRUE(all_read.contains(what) || wire::slot_class(what.first) == wire::SlotClass::kStream)
        << wire::slot_name(what.first) << " in " << partition;
}

INSTANTIATE_TEST_SUITE_P(DdsRecording, TwoRecordings,
                         ::testing::Values("", "dds: {karma: cyclonedds, heliv: cyclonedds}\n"),
                         [](const auto& one) {
                           return std::string(one.param).empty() ? "fastdds" : "mixed";
                         });

TEST(DdsRecording, WithKeysNothingIsSeenAndThatIsSaid) {
  DdsRun run;
  auto spy = run_tool::Process::start(
      {kPrograms + "/skein", "spy", "--domain", "99", "--security", run.file("keys").string(),
       "record", run.file("x.mcap").string(), "--passive"},
      run.file("log").string());
  ASSERT_TRUE(spy.has_value());
  ASSERT_TRUE(holds_within(20, [&] { return spy->poll().has_value(); }));
  EXPECT_EQ(spy->poll()->code, kExitSystem);
  std::ifstream in(run.file("log"));
  EXPECT_THAT(std::string(std::istreambuf_iterator<char>(in), {}), HasSubstr("protected by keys"));
}

}  // namespace
}  // namespace skein::testing
