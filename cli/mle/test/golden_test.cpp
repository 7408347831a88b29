// SPDX-License-Identifier: Apache-2.0
// The traces of tests/golden/mle, each replayed and compared with the lines expected of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "skein/mle_tool/mle.hpp"

namespace skein::mle_tool {
namespace {

namespace fs = std::filesystem;

const fs::path kCases = fs::path(SKEIN_SOURCE_DIR) / "tests" / "golden" / "mle";

std::string content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  EXPECT_TRUE(in) << file;
  return std::string(std::istreambuf_iterator<char>(in), {});
}

std::vector<std::string> case_names() {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(kCases)) {
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

// The words of the file `args`: options as on the command line, each with its value.
MleOptions options_of(const fs::path& folder) {
  MleOptions options;
  if (!fs::exists(folder / "args")) return options;
  std::istringstream words(content(folder / "args"));
  std::string option;
  std::string value;
  while (words >> option >> value) {
    if (option == "--uav") {
      options.uav = value;
    } else if (option == "--until") {
      options.until = MissionTime::seconds(std::stod(value));
    } else if (option == "--timeout") {
      options.timeout = Duration::seconds(std::stod(value));
    } else if (option == "--sync-validity") {
      options.sync_validity = Duration::seconds(std::stod(value));
    } else if (option == "--background") {
      options.background = value;
    } else {
      ADD_FAILURE() << folder << "/args: unknown option " << option;
    }
  }
  return options;
}

struct Replayed {
  int code = 0;
  std::string out;
};

Replayed replay(const fs::path& folder) {
  std::istringstream in(content(folder / "in.jsonl"));
  std::ostringstream out;
  std::ostringstream err;
  const int code = run_mle(options_of(folder), in, out, err);
  return Replayed{code, out.str()};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// From the first line that differs on, with two lines before it; empty when nothing differs.
std::string difference(const std::string& expected, const std::string& actual) {
  if (expected == actual) return "";
  const std::vector<std::string> wanted = lines_of(expected);
  const std::vector<std::string> got = lines_of(actual);
  const auto [first, other] = std::mismatch(wanted.begin(), wanted.end(), got.begin(), got.end());
  const auto at = static_cast<std::size_t>(first - wanted.begin());
  std::string text = "first difference at line " + std::to_string(at + 1) + "\n";
  for (std::size_t i = at < 2 ? 0 : at - 2; i < at; ++i) text += "  " + wanted[i] + "\n";
  for (std::size_t i = at; i < std::min(at + 5, wanted.size()); ++i)
    text += "- " + wanted[i] + "\n";
  for (std::size_t i = at; i < std::min(at + 5, got.size()); ++i) text += "+ " + got[i] + "\n";
  return text;
}

class GoldenTrace : public testing::TestWithParam<std::string> {
 protected:
  fs::path folder() const { return kCases / GetParam(); }
};

TEST_P(GoldenTrace, GivesTheLinesExpectedOfIt) {
  const std::string expected = content(folder() / "out.jsonl");

  const Replayed replayed = replay(folder());

  EXPECT_EQ(difference(expected, replayed.out), "");
}

TEST_P(GoldenTrace, GivesTheSameLinesEachTime) {
  EXPECT_EQ(replay(folder()).out, replay(folder()).out);
}

TEST_P(GoldenTrace, EndsEachLine) {
  const Replayed replayed = replay(folder());

  ASSERT_FALSE(replayed.out.empty());
  EXPECT_EQ(replayed.out.back(), '\n');
  EXPECT_EQ(replayed.out.find("\n\n"), std::string::npos);
}

TEST_P(GoldenTrace, FailsOnlyWhenALineWasWrong) {
  const Replayed replayed = replay(folder());

  const bool refused_a_line = replayed.out.find("\"refused\":\"line\"") != std::string::npos;
  EXPECT_EQ(replayed.code, refused_a_line ? 1 : 0);
}

std::string test_name(const testing::TestParamInfo<std::string>& one) {
  std::string name = one.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Cases, GoldenTrace, testing::ValuesIn(case_names()), test_name);

TEST(GoldenTraces, CoverTheExampleOfTheSpec) {
  const std::vector<std::string> names = case_names();

  EXPECT_TRUE(std::find(names.begin(), names.end(), "example-2-9") != names.end());
}

TEST(Difference, ShowsTheFirstLineThatDiffersWithWhatIsBeforeIt) {
  EXPECT_EQ(difference("a\nb\nc\nd\n", "a\nb\nc\nx\n"),
            "first difference at line 4\n  b\n  c\n- d\n+ x\n");
  EXPECT_EQ(difference("a\n", "a\nb\n"), "first difference at line 2\n  a\n+ b\n");
  EXPECT_EQ(difference("a\n", "a\n"), "");
}

}  // namespace
}  // namespace skein::mle_tool
