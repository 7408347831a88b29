// SPDX-License-Identifier: Apache-2.0
// Commands run on texts and folders, for tests.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace skein::temporal_tool::testing {

struct Outcome {
  int code = 0;
  std::string out;
  std::string err;
};

/// A command that reads `input` from standard input.
template <class Command, class Options>
Outcome run(Command command, const Options& options, const std::string& input) {
  std::istringstream in(input);
  std::ostringstream out;
  std::ostringstream err;
  const int code = command(options, in, out, err);
  return {code, out.str(), err.str()};
}

/// A command that reads none.
template <class Command, class Options>
Outcome run(Command command, const Options& options) {
  std::ostringstream out;
  std::ostringstream err;
  const int code = command(options, out, err);
  return {code, out.str(), err.str()};
}

/// An empty folder of its own for each test.
inline std::filesystem::path fresh_folder() {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(::testing::TempDir()) /
                      (std::string(info->test_suite_name()) + "." + info->name());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

inline void put(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

}  // namespace skein::temporal_tool::testing
