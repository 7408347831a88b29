// SPDX-License-Identifier: Apache-2.0
#include "skein/store/incarnation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <map>

#include "testing/entries.hpp"

namespace skein::store {
namespace {

using ::testing::HasSubstr;

constexpr std::uint64_t kToday = 1'795'000'000'000'000'000;

TEST(Incarnations, BeginWithTheClock) {
  const testing::Folder folder;
  EXPECT_EQ(next_incarnation(folder.path(), "marvin", kToday).value().number, kToday);
  EXPECT_EQ(folder.names(), "marvin.incarnation ");
}

TEST(Incarnations, GoOnWhereTheClockDoesNot) {
  const testing::Folder folder;
  ASSERT_TRUE(next_incarnation(folder.path(), "marvin", kToday).has_value());
  EXPECT_EQ(next_incarnation(folder.path(), "marvin", 0).value().number, kToday + 1)
      << "booted into 1970";
  EXPECT_EQ(next_incarnation(folder.path(), "marvin", 5).value().number, kToday + 2);
  EXPECT_EQ(next_incarnation(folder.path(), "marvin", kToday + 9).value().number, kToday + 9);
}

TEST(Incarnations, AreOnDiskInAFolderThatWasNotThere) {
  const testing::Folder folder;
  const auto deep = folder.path() / "var" / "skein";
  ASSERT_TRUE(next_incarnation(deep, "marvin", 7).has_value());
  std::ifstream in(deep / "marvin.incarnation");
  std::uint64_t kept = 0;
  in >> kept;
  EXPECT_EQ(kept, 7U);
}

TEST(Incarnations, AreNotGuessedFromWhatIsNoNumber) {
  for (const char* text :
       {"", "7", "x\n", "7 8\n", "-1\n", "99999999999999999999\n", "18446744073709551615\n"}) {
    const testing::Folder folder;
    const auto file = folder.path() / "marvin.incarnation";
    std::ofstream(file) << text;
    const auto next = next_incarnation(folder.path(), "marvin", kToday);
    ASSERT_FALSE(next.has_value()) << text;
    EXPECT_THAT(next.error().why, HasSubstr("marvin.incarnation: no number"));
    std::ifstream in(file);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), text) << "it stays as it is";
  }
}

TEST(Incarnations, AreNotGivenWhereTheyCannotBeKept) {
  const testing::Folder folder;
  std::ofstream(folder.path() / "file") << "no folder";
  const auto next = next_incarnation(folder.path() / "file", "marvin", kToday);
  ASSERT_FALSE(next.has_value());
}

RC_GTEST_PROP(IncarnationsLaw, GrowForEachNodeWhateverTheClockDoes, ()) {
  const testing::Folder folder;
  std::map<std::string, std::uint64_t> last;
  const auto boots = *rc::gen::container<std::vector<std::pair<bool, std::uint64_t>>>(
      rc::gen::pair(rc::gen::arbitrary<bool>(), rc::gen::inRange<std::uint64_t>(0, 2 * kToday)));
  for (const auto& [marvin, clock] : boots) {
    const std::string node = marvin ? "marvin" : "heliv";
    const auto next = next_incarnation(folder.path(), node, clock);
    RC_ASSERT(next.has_value());
    RC_ASSERT(next->number > last[node]);
    RC_ASSERT(next->number >= clock);
    RC_ASSERT(next->first == (last[node] == 0));
    last[node] = next->number;
  }
}

}  // namespace
}  // namespace skein::store
