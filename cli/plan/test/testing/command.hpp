// SPDX-License-Identifier: Apache-2.0
// `skein plan` called as a function, and files of a test's own.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "skein/plan_tool/plan.hpp"

namespace skein::plan_tool::testing_command {

struct Done {
  int code = 0;
  std::string out;
  std::string err;
};

inline Done plan(const PlanOptions& options, const Surroundings& surroundings = {},
                 const std::string& input = "") {
  std::istringstream in(input);
  std::ostringstream out;
  std::ostringstream err;
  const int code = run_plan(options, surroundings, in, out, err);
  return {code, out.str(), err.str()};
}

/// One of libs/htn/test/domains.
inline std::string domain_file(const std::string& name) {
  return std::string(SKEIN_SOURCE_DIR) + "/libs/htn/test/domains/" + name;
}

inline PlanOptions options_for(const std::string& file, const std::string& problem = "") {
  PlanOptions options;
  options.files = {domain_file(file)};
  if (!problem.empty()) options.problems = {problem};
  return options;
}

/// A file of the test's own, gone with it.
class File {
 public:
  File(const std::string& name, const std::string& content)
      : path_(std::filesystem::path(testing::TempDir()) /
              (std::string("plan_test_") +
               testing::UnitTest::GetInstance()->current_test_info()->name() + '_' + name)) {
    std::ofstream(path_, std::ios::binary) << content;
  }
  ~File() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  std::string path() const { return path_.string(); }
  std::string content() const {
    std::ifstream in(path_, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  }

 private:
  std::filesystem::path path_;
};

}  // namespace skein::plan_tool::testing_command
