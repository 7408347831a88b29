// SPDX-License-Identifier: Apache-2.0
// The given domains and problems are read without an error. They are not part of the repository.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "testing/reader_fixture.hpp"

namespace skein::htn {
namespace {

namespace fs = std::filesystem;

fs::path shared_data() {
  const char* given = std::getenv("SKEIN_SHARED_DATA");
  return given != nullptr ? fs::path(given) / "shop"
                          : fs::path(SKEIN_SOURCE_DIR) / "../shared/data/shop";
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class SharedData : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(shared_data())) GTEST_SKIP() << "no " << shared_data();
  }
  static void read(testing::ReaderFixture& reader, const std::string& file) {
    reader.read(text_of(shared_data() / file), file);
  }
};

TEST_F(SharedData, IsReadWithoutError) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(shared_data())) {
    if (entry.path().extension() == ".lisp") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());

  ASSERT_FALSE(files.empty());
  for (const fs::path& file : files) {
    testing::ReaderFixture reader;
    reader.read(text_of(file), file.filename());
    EXPECT_EQ(reader.error_text(), "") << file;
    EXPECT_FALSE(reader.definitions.domains.empty() && reader.definitions.problems.empty()) << file;
  }
}

TEST_F(SharedData, HoldsTheDefinitionsItIsKnownToHold) {
  testing::ReaderFixture blocks;
  read(blocks, "blocks/block2.lisp");
  read(blocks, "blocks/problem100.lisp");
  testing::ReaderFixture rovers;
  read(rovers, "rovers-strips/domain.lisp");

  EXPECT_EQ(blocks.domain().name, "blocks-normal");
  EXPECT_EQ(blocks.domain().operators.size(), 6U);
  EXPECT_EQ(blocks.domain().methods.size(), 12U);
  EXPECT_EQ(blocks.definitions.problems.at(0).name, "bw_ran_100_1");
  EXPECT_EQ(blocks.warning_text(), "");
  EXPECT_TRUE(rovers.domain().pddl);
  EXPECT_EQ(rovers.domain().operators.size(), 10U);
  EXPECT_EQ(rovers.domain().static_predicates.size(), 9U);
}

TEST_F(SharedData, HasTheMistakesItIsKnownToHave) {
  testing::ReaderFixture depots;
  read(depots, "ipc02-depots-simpletime/stdepots.lisp");
  testing::ReaderFixture zeno;
  read(zeno, "ipc02-zeno-simpletime/zenotravelSimpleTime.lisp");

  EXPECT_NE(depots.warning_text().find("stdepots.lisp:321:85: task 'load-truck' with 3 arguments "
                                       "matches no head; expected 4"),
            std::string::npos);
  EXPECT_NE(zeno.warning_text().find("a branch without tasks"), std::string::npos);
}

}  // namespace
}  // namespace skein::htn
