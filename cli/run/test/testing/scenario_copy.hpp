// SPDX-License-Identifier: Apache-2.0
// A folder of a test's own, and copies of the COMETS scenario with changes.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace skein::run_tool::testing {

namespace fs = std::filesystem;

inline const std::string kComets = std::string(SKEIN_SOURCE_DIR) + "/scenarios/comets/";

inline std::string read_text(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void write_text(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// Made empty at the start, removed at the end.
class Folder {
 public:
  Folder() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    path_ = fs::temp_directory_path() /
            ("skein-" + std::string(test->name()) + "-" + std::to_string(getpid()));
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }

  fs::path operator/(const std::string& name) const { return path_ / name; }
  std::string text() const { return path_.string(); }

 private:
  fs::path path_;
};

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// The text of scenarios/comets/NAME.yaml, readable from any folder.
inline std::string comets_text(const std::string& name) {
  const std::string with_models = replaced(read_text(kComets + name + ".yaml"), "model: models/",
                                           "model: " + kComets + "models/");
  return replaced(with_models, "include: ../", "include: " + kComets + "../");
}

}  // namespace skein::run_tool::testing
