// SPDX-License-Identifier: Apache-2.0
// The networks of tests/golden/stn, each given to the command of its file `args`, and what is
// printed compared with what is expected. SKEIN_WRITE_GOLDEN=1 writes the expectations anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "skein/temporal_tool/stn.hpp"

namespace skein::temporal_tool {
namespace {

namespace fs = std::filesystem;

const fs::path kCases = fs::path(SKEIN_SOURCE_DIR) / "tests" / "golden" / "stn";

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

/// The words of the file `args`, as on the command line.
class Arguments {
 public:
  explicit Arguments(const std::string& line) {
    std::istringstream in(line);
    for (std::string word; in >> word;) words_.push_back(word);
  }

  const std::string& command() const { return words_.at(0); }
  bool has(const std::string& flag) const {
    return std::find(words_.begin(), words_.end(), flag) != words_.end();
  }
  std::string value(const std::string& option, const std::string& otherwise) const {
    const auto found = std::find(words_.begin(), words_.end(), option);
    return found == words_.end() ? otherwise : *std::next(found);
  }

 private:
  std::vector<std::string> words_;
};

int run(const Arguments& arguments, std::istream& in, std::ostream& out, std::ostream& err) {
  StnOptions common;
  common.json = arguments.has("--json");
  const std::string& command = arguments.command();
  if (command == "check") return check_stn({common, arguments.has("--dates")}, in, out, err);
  if (command == "dc") return check_stn_controllability(common, in, out, err);
  if (command == "dispatch") {
    const std::string starts = arguments.value("--starts", "earliest");
    return dispatch_stn({common, std::stoul(arguments.value("--seed", "1")),
                         starts == "random" ? StnStarts::kRandom : StnStarts::kEarliest},
                        in, out, err);
  }
  if (command == "draw") {
    return draw_stn({common, arguments.has("--dot"), arguments.value("--title", ""), ""}, in, out,
                    err);
  }
  EXPECT_EQ(command, "convert");
  return convert_stn({common, arguments.value("--to", ""), ""}, in, out, err);
}

// All that the command gives, in one text.
std::string played(const fs::path& folder) {
  std::istringstream in(content(folder / "in"));
  std::ostringstream out;
  std::ostringstream err;
  const int code = run(Arguments(content(folder / "args")), in, out, err);
  return out.str() + (err.str().empty() ? "" : "--- standard error\n" + err.str()) +
         "--- exit code " + std::to_string(code) + "\n";
}

class GoldenNetwork : public testing::TestWithParam<std::string> {};

TEST_P(GoldenNetwork, GivesWhatIsExpectedOfIt) {
  const fs::path folder = kCases / GetParam();

  const std::string actual = played(folder);

  if (std::getenv("SKEIN_WRITE_GOLDEN") != nullptr) std::ofstream(folder / "expected") << actual;
  EXPECT_EQ(actual, content(folder / "expected"));
}

std::string test_name(const testing::TestParamInfo<std::string>& one) {
  std::string name = one.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Cases, GoldenNetwork, testing::ValuesIn(case_names()), test_name);

}  // namespace
}  // namespace skein::temporal_tool
