// SPDX-License-Identifier: Apache-2.0
// A mission beside somebody who says again what its nodes have just said, in their names and of
// their present lives, with fields changed: numbers, times, names and lists, also of the headers.
// All of it is well-formed, and some of it is believed. What becomes of the mission is not asked,
// but no daemon ends otherwise than it was told to.
#include <gmock/gmock.h>

#include <csignal>
#include <fstream>
#include <iostream>
#include <iterator>

#include "recorder.hpp"
#include "skein/blackboard/cdr.hpp"
#include "test_cases.hpp"
#include "testing/dds_run.hpp"
#include "testing/foul.hpp"

namespace skein::testing {
namespace {

using blackboard::testing::Fouler;
using spy_tool::Taken;
using ::testing::IsEmpty;

std::vector<Taken> samples_in(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  std::vector<Taken> samples;
  spy_tool::samples_of(bytes, [&](Taken one) { samples.push_back(std::move(one)); });
  return samples;
}

void write_samples(const fs::path& file, const std::vector<Taken>& samples) {
  std::ofstream out(file, std::ios::binary);
  spy_tool::Recorder recorder(false, [&](std::string_view bytes) { out << bytes; });
  for (const Taken& one : samples) recorder.take(one);
  recorder.close();
}

/// Changes what was said, and numbers most of it as if it were said next.
class Liar {
 public:
  explicit Liar(std::uint64_t seed) : random_(seed, "liar"), fouler_(seed, Fouler::Changes::kAll) {}

  /// False for what is not said again: the clock, which may end a mission whenever it likes.
  bool spoil(Taken& taken) {
    if (taken.slot == wire::Slot::kClock) return false;
    const auto content = blackboard::decode(
        taken.slot,
        {reinterpret_cast<const std::uint8_t*>(taken.bytes.data()), taken.bytes.size()});
    const auto* fair = std::get_if<wire::Sample>(&content);
    if (fair == nullptr) return false;
    wire::Sample foul = random_.chance(0.8) ? fouler_.foul(*fair) : *fair;
    if (random_.chance(0.7)) wire::header_of(foul).sequence_number += random_.below(200);
    const auto bytes = blackboard::in_cdr(foul);
    taken.bytes.assign(bytes.begin(), bytes.end());
    return true;
  }

 private:
  Random random_;
  Fouler fouler_;
};

/// A few seconds of a mission, spoilt, into its ears; the number of samples said.
class DdsFoulWords : public ::testing::TestWithParam<std::string> {
 protected:
  static std::size_t play(DdsRun& run, std::uint64_t seed) {
    run.take_scenario("confirmed");
    run.start({"--rate", "5", "--dds", GetParam()});
    run.wait_for_output("the mission starts");
    const std::string fair = run.file("fair.mcap").string(), foul = run.file("foul.mcap").string();
    EXPECT_EQ(run.skein({"spy", "--duration", "3", "record", fair}).code, 0);
    std::vector<Taken> samples = samples_in(fair);
    Liar liar(seed);
    std::erase_if(samples, [&](Taken& one) { return !liar.spoil(one); });
    write_samples(foul, samples);
    const Answered played = run.skein({"spy", "--dds", GetParam(), "play", foul});
    EXPECT_EQ(played.code, 0) << played.text;
    return samples.size();
  }
  /// Whose end was another one than it was told, or that the mission was over.
  static std::vector<std::string> crashed(const DdsRun& run) {
    std::vector<std::string> names;
    for (const journal::Record& record : run.records())
      if (record.kind() == "process" && record.text("state") == "crashed")
        names.push_back(std::string(record.text("name")) + ": " + std::string(record.text("why")));
    return names;
  }
};

TEST_P(DdsFoulWords, EndNoDaemonWhateverTheySayInTheNamesOfOthers) {
  const char* first = std::getenv("SKEIN_FIRST_SEED");
  const std::uint64_t from = first != nullptr ? std::stoull(first) : 1;
  const auto seeds = cases<std::uint64_t>(2, 20);
  for (std::uint64_t seed = from; seed < from + seeds; ++seed) {
    DdsRun run;
    const std::size_t said = play(run, seed);
    std::cout << GetParam() << " seed " << seed << ": " << said << " samples" << std::endl;
    EXPECT_GT(said, 200U);
    run.send(SIGINT);
    EXPECT_TRUE(run.wait().has_value());
    EXPECT_THAT(crashed(run), IsEmpty()) << "seed " << seed;
    EXPECT_EQ(run.count("process", "state", "exited"), 5U);
  }
}

INSTANTIATE_TEST_SUITE_P(OfEachVendor, DdsFoulWords, ::testing::Values("fastdds", "cyclonedds"),
                         [](const auto& of) { return of.param; });

}  // namespace
}  // namespace skein::testing
