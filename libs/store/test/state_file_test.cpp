// SPDX-License-Identifier: Apache-2.0
#include "skein/store/state_file.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "testing/entries.hpp"

namespace skein::store {
namespace {

using ::testing::HasSubstr;
using testing::one_of_each;

class AStateFile : public ::testing::Test {
 protected:
  void live() {
    const auto opened = SqliteInputLog::open(folder.path(), {"marvin", "comets 1"});
    ASSERT_TRUE(opened.has_value());
    for (const node::LogEntry& entry : one_of_each()) ASSERT_TRUE(opened->log->append(entry));
    opened->log->told(7);
  }
  std::filesystem::path file() const { return folder.path() / "marvin.state"; }

  testing::Folder folder;
};

TEST_F(AStateFile, TellsWhoseItIsAndWhatIsInIt) {
  live();

  const auto found = examine(file());

  ASSERT_TRUE(found.has_value()) << found.error().why;
  EXPECT_EQ(found->identity, (Identity{"marvin", "comets 1"}));
  EXPECT_EQ(found->version, 4);
  EXPECT_TRUE(found->complete);
  EXPECT_FALSE(found->over);
  EXPECT_EQ(found->inputs, one_of_each().size());
  EXPECT_EQ(found->lives, 2U);
  EXPECT_EQ(found->lines, 7U);
  EXPECT_EQ(found->from, MissionTime());
  EXPECT_EQ(found->until, one_of_each().back().at);
  EXPECT_EQ(found->by_kind.at("received Telemetry"), 1U);
  EXPECT_EQ(found->by_kind.at("reachability"), 2U);
  EXPECT_GT(found->bytes, 4096U);
}

TEST_F(AStateFile, IsReadWhileADaemonUsesIt) {
  const auto opened = SqliteInputLog::open(folder.path(), {"marvin", "comets 1"});
  ASSERT_TRUE(opened->log->append({MissionTime(), node::Started{1}}));

  EXPECT_EQ(examine(file())->inputs, 1U);
  EXPECT_TRUE(opened->log->append({MissionTime(), node::Wakeup{}}));
  EXPECT_EQ(examine(file())->inputs, 2U);
}

TEST_F(AStateFile, GivesItsInputsInTheirOrder) {
  live();
  std::vector<std::string> found, wanted;
  for (const node::LogEntry& entry : one_of_each()) wanted.push_back(testing::to_text(entry));

  const auto read = for_each_input(file(), [&](std::uint64_t number, const node::LogEntry& entry) {
    EXPECT_EQ(number, found.size() + 1);
    found.push_back(testing::to_text(entry));
  });

  EXPECT_TRUE(read.has_value());
  EXPECT_EQ(found, wanted);
}

TEST_F(AStateFile, OfAProgramWithOtherMessagesIsKnown) {
  live();
  EXPECT_TRUE(examine(file())->of_this_wire);
  SQLite::Database(file().string(), SQLite::OPEN_READWRITE)
      .exec("UPDATE about SET value = '0123456789abcdef' WHERE what = 'messages'");

  EXPECT_FALSE(examine(file())->of_this_wire);
}

TEST_F(AStateFile, ThatIsNoneIsNamed) {
  std::ofstream(folder.path() / "text") << "hello, this is no database at all";

  EXPECT_THAT(examine(folder.path() / "nosuch").error().why, HasSubstr("nosuch: no such file"));
  EXPECT_THAT(examine(folder.path() / "text").error().why, HasSubstr("text: damaged: "));
}

}  // namespace
}  // namespace skein::store
