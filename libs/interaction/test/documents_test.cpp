// SPDX-License-Identifier: Apache-2.0
// Files of a library that use each other.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "skein/config/parse.hpp"
#include "skein/interaction/read_library.hpp"

namespace skein::interaction {
namespace {

using ::testing::ElementsAre;

class DocumentsOf : public ::testing::Test {
 protected:
  void has(const std::string& file, const std::string& uses) {
    files_[file] = "uses: [" + uses + "]\n";
  }
  Result<std::vector<Document>, Diagnostics> documents_of(const std::vector<std::string>& files) {
    return interaction::documents_of(
        files, [&](const std::string& path) -> Result<config::Value, Diagnostics> {
          asked_.push_back(path);
          const auto found = files_.find(path);
          if (found != files_.end()) return config::parse_yaml(found->second, path);
          return config::parse_yaml("[", path);  // as of a file that cannot be read
        });
  }
  std::vector<std::string> names_of(const std::vector<std::string>& files) {
    std::vector<std::string> names;
    const auto documents = documents_of(files);
    if (!documents) return {to_text(documents.error())};
    for (const Document& one : *documents) names.push_back(one.file);
    return names;
  }

  std::vector<std::string> asked_;

 private:
  std::map<std::string, std::string> files_;
};

TEST_F(DocumentsOf, AreFollowedByWhatEachUsesSeenFromWhereItIs) {
  has("models/pair.yaml", "roles.yaml, ../common/scms.yaml");
  has("models/roles.yaml", "./more/points.yaml");
  has("models/more/points.yaml", "");
  has("common/scms.yaml", "/shared/words.yaml");
  has("/shared/words.yaml", "");

  EXPECT_THAT(names_of({"models/pair.yaml"}),
              ElementsAre("models/pair.yaml", "models/roles.yaml", "models/more/points.yaml",
                          "common/scms.yaml", "/shared/words.yaml"));
}

TEST_F(DocumentsOf, AreReadOnceHoweverTheyAreCalledAndWhoeverUsesThem) {
  has("a/one.yaml", "../b/other.yaml");
  has("b/other.yaml", "../a/one.yaml, ../b/./other.yaml");

  EXPECT_THAT(names_of({"a/one.yaml", "a/../b/other.yaml"}),
              ElementsAre("a/one.yaml", "b/other.yaml"));
  EXPECT_THAT(asked_, ElementsAre("a/one.yaml", "b/other.yaml"));
}

TEST_F(DocumentsOf, LeaveTheFolderThatTheyAreSeenFromWhenTheySaySo) {
  has("one.yaml", "../../far/other.yaml");
  has("../../far/other.yaml", "../nearer.yaml");
  has("../../nearer.yaml", "");

  EXPECT_THAT(names_of({"one.yaml"}),
              ElementsAre("one.yaml", "../../far/other.yaml", "../../nearer.yaml"));
}

TEST_F(DocumentsOf, AreRefusedWithEveryFileThatCannotBeRead) {
  has("one.yaml", "lost.yaml, also-lost.yaml");

  const auto documents = documents_of({"one.yaml"});

  ASSERT_FALSE(documents);
  const std::string text = to_text(documents.error());
  EXPECT_NE(text.find("lost.yaml:"), std::string::npos) << text;
  EXPECT_NE(text.find("also-lost.yaml:"), std::string::npos) << text;
  EXPECT_THAT(asked_, ElementsAre("one.yaml", "lost.yaml", "also-lost.yaml"));
}

}  // namespace
}  // namespace skein::interaction
