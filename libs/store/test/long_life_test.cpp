// SPDX-License-Identifier: Apache-2.0
// What is not the last of a state file is folded, bytes that are others are found out, and the file
// has a bound.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "database.hpp"
#include "row.hpp"
#include "skein/foundation/random.hpp"
#include "testing/full_disk.hpp"
#include "testing/state_on_disk.hpp"

namespace skein::store {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::leave_version;
using testing::texts;
using testing::texts_of_lives;

class LongLife : public testing::StateOnDisk {
 protected:
  fs::path ahead() const { return state().string() + "-wal"; }
};

/// A long life: telemetry with a plan board now and then.
std::vector<node::LogEntry> long_life(int inputs) {
  std::vector<node::LogEntry> life{{MissionTime(), node::Started{1}}};
  wire::Telemetry telemetry;
  telemetry.uav = "marvin";
  wire::PlanBoard board;
  for (std::uint64_t id = 1; id <= 30; ++id) board.tasks.push_back({id, "goto", {}, ""});
  for (int i = 1; i < inputs; ++i) {
    const MissionTime at = MissionTime::seconds(i);
    telemetry.position.x = 0.3F * static_cast<float>(i);
    board.tasks[static_cast<std::size_t>(i % 30)].id += 1000;
    if (i % 7 == 0)
      life.push_back({at, node::Wakeup{}});
    else if (i % 50 == 0)
      life.push_back({at, node::Received{node::NodeNumber(2), board}});
    else
      life.push_back({at, node::Received{node::NodeNumber(2), telemetry}});
  }
  return life;
}

constexpr int kLong = 2 * static_cast<int>(kFoldedRows) + 100;

TEST_F(LongLife, ALongLifeIsKeptInItsOrderAndGoneOnFrom) {
  std::vector<node::LogEntry> lives = long_life(kLong);
  {
    const Opened first = open();
    for (const node::LogEntry& entry : lives) ASSERT_TRUE(first.log->append(entry));
  }
  lives.push_back({MissionTime::seconds(kLong), node::Resumed{}});
  ASSERT_TRUE(open().log->append(lives.back()));
  node::MemoryInputLog memory;
  for (const node::LogEntry& entry : lives) ASSERT_TRUE(memory.append(entry));

  const Opened next = open();

  EXPECT_EQ(next.set_aside, "");
  EXPECT_EQ(texts(*next.log), texts(lives));
  EXPECT_EQ(texts_of_lives(*next.log), texts_of_lives(memory));
  SQLite::Database file(state().string());
  EXPECT_EQ(file.execAndGet("SELECT count(*) FROM folds").getInt(), 2);
  EXPECT_EQ(file.execAndGet("SELECT count(*) FROM inputs").getInt(), 101);
}

TEST_F(LongLife, ALongLifeOfVersion3IsFoldedWhenItIsOpened) {
  leave_version(3, state());
  SQLite::Database(state().string(), SQLite::OPEN_READWRITE)
      .exec(
          "WITH RECURSIVE n(i) AS (VALUES (3) UNION ALL SELECT i + 1 FROM n WHERE i < 10000) "
          "INSERT INTO inputs SELECT i, i * 1000, 'wakeup', 0, '', 0, 0, 0, x'' FROM n");

  const Opened next = open();

  EXPECT_EQ(next.set_aside, "");
  EXPECT_EQ(texts(*next.log).size(), 10'000U);
  EXPECT_EQ(SQLite::Database(state().string()).execAndGet("SELECT count(*) FROM folds").getInt(),
            3);
}

/// A transaction of this test: a row, or the fold of kFoldedRows.
constexpr std::uintmax_t kTransaction = 256U << 10;

TEST_F(LongLife, TheWriteAheadLogHasABound) {
  const Opened opened = open();
  std::uintmax_t largest = 0;
  for (const node::LogEntry& entry : long_life(kLong)) {
    ASSERT_TRUE(opened.log->append(entry));
    largest = std::max(largest, fs::file_size(ahead()));
  }
  EXPECT_GT(largest, 100'000U);
  EXPECT_LE(largest, kLargestAhead + kTransaction);
}

TEST_F(LongLife, WhatTheWriteAheadLogGrewByWhileSomebodyReadIsGivenBack) {
  const std::vector<node::LogEntry> life = long_life(kLong);
  const auto half = life.begin() + kLong / 2;
  const Opened opened = open();
  ASSERT_TRUE(opened.log->append(life.front()));
  {
    Database reader(state().string(), Database::Mode::kRead);
    reader.raw().exec("BEGIN");
    ASSERT_EQ(reader.inputs(), 1U);
    for (auto entry = life.begin() + 1; entry != half; ++entry)
      ASSERT_TRUE(opened.log->append(*entry));
    ASSERT_GT(fs::file_size(ahead()), 2 * kLargestAhead);
  }
  for (auto entry = half; entry != life.end(); ++entry) ASSERT_TRUE(opened.log->append(*entry));

  EXPECT_LE(fs::file_size(ahead()), kLargestAhead + kTransaction);
}

TEST_F(LongLife, AnInputThatIsMissingIsNamed) {
  {
    const Opened life = open();
    for (const node::LogEntry& entry : long_life(5000)) ASSERT_TRUE(life.log->append(entry));
  }
  SQLite::Database(state().string(), SQLite::OPEN_READWRITE).exec("DELETE FROM folds");

  EXPECT_EQ(texts(*open().log).back(), "FAILED " + state().string() + ": input 1: missing");
}

// A disk that gives back other bytes than it took is found out, whichever they are: never another
// input, never a crash.
TEST_F(LongLife, AByteThatIsAnotherNeverMakesAnotherInput) {
  const std::vector<node::LogEntry> life = long_life(4200);
  {
    const Opened first = open();
    for (const node::LogEntry& entry : life) ASSERT_TRUE(first.log->append(entry));
  }
  const std::vector<std::string> kept = texts(life);
  const fs::path sound = folder.path() / "sound";
  fs::copy_file(state(), sound);
  const auto size = static_cast<std::uint64_t>(fs::file_size(sound));
  int found = 0;
  for (std::uint64_t n = 0; n < 160; ++n) {
    const std::uint64_t at = n < 60 ? n : n * 7919 % size;
    fs::copy_file(sound, state(), fs::copy_options::overwrite_existing);
    {
      std::fstream file(state(), std::ios::in | std::ios::out | std::ios::binary);
      file.seekg(static_cast<std::streamoff>(at));
      const int byte = file.get();
      file.seekp(static_cast<std::streamoff>(at));
      file.put(static_cast<char>(byte ^ (1 << n % 8)));
    }
    std::vector<std::string> read;
    {
      const Opened opened = open();
      read = texts(*opened.log);
      if (!opened.set_aside.empty()) ++found;
      if (opened.set_aside.empty() && !read.empty() && read.back().rfind("FAILED", 0) == 0) {
        read.pop_back();
        ++found;
      }
    }
    ASSERT_LE(read.size(), kept.size()) << "byte " << at;
    EXPECT_TRUE(std::equal(read.begin(), read.end(), kept.begin())) << "byte " << at;
    for (const auto& entry : fs::directory_iterator(folder.path()))
      if (entry.path().filename() != "sound") fs::remove(entry.path());
    std::ofstream(folder.path() / "marvin.complete").put('\n');
  }
  EXPECT_GT(found, 20);
}

/// A plan board of some 50 kB that nothing makes much smaller.
node::LogEntry a_board(std::uint64_t number) {
  Random random(number, "boards");
  wire::PlanBoard board;
  for (int i = 0; i < 2000; ++i) board.tasks.push_back({random.below(1U << 31), "goto", {}, ""});
  return {MissionTime::seconds(static_cast<double>(number)),
          node::Received{node::NodeNumber(2), board}};
}

TEST_F(LongLife, WhereThereIsRoomForWhatComesButNotToFoldItIsSaidOnceAndAgainWhenThereIs) {
  constexpr std::uintmax_t kRoom = 200'000;
  const std::uint64_t to_fold = kFoldedBytes / row_of(a_board(1)).body.size() + 1;
  const Opened life = open();
  std::vector<std::string> news;
  const auto keep = [&](std::uint64_t number) {
    ASSERT_TRUE(life.log->append(a_board(number)).has_value()) << number;
    if (std::string one = life.log->take_news(); !one.empty()) news.push_back(one);
  };

  for (std::uint64_t number = 0; number < 2 * to_fold; ++number) {
    const std::uintmax_t before = number == 0 ? 0 : fs::file_size(state().string() + "-wal");
    const testing::FullDisk full(before + kRoom);
    keep(number);
  }
  EXPECT_THAT(news, ::testing::ElementsAre(
                        HasSubstr("marvin.state: older inputs are not folded, it grows faster: ")));
  for (std::uint64_t number = 2 * to_fold; number < 3 * to_fold; ++number) keep(number);

  EXPECT_THAT(news, ::testing::ElementsAre(
                        ::testing::_, HasSubstr("marvin.state: older inputs are folded again")));
  EXPECT_EQ(texts(*life.log).size(), 3 * to_fold);
  SQLite::Database file(state().string());
  EXPECT_EQ(file.execAndGet("SELECT count(*) FROM inputs").getInt(), 0);
}

TEST_F(LongLife, ItIsSaidOnceWhenAFileHasThreeQuartersOfWhatItMayHave) {
  auto opened = SqliteInputLog::open(folder.path(), {"marvin", "comets 1"}, 8U << 20);
  ASSERT_TRUE(opened.has_value());
  std::vector<std::string> news;
  for (std::uint64_t number = 0; number < 1000; ++number) {
    if (!opened->log->append(a_board(number))) break;
    if (std::string one = opened->log->take_news(); !one.empty()) news.push_back(one);
  }

  ASSERT_FALSE(news.empty());
  EXPECT_THAT(news.front(), ::testing::ContainsRegex("marvin.state: it has (7[5-9]|8.|9.) % of the "
                                                     "8 MB that it may have"));
  EXPECT_EQ(std::count_if(news.begin(), news.end(),
                          [](const std::string& one) { return one.find("% of") != one.npos; }),
            1);
}

TEST_F(LongLife, AFileIsNeverLargerThanItMayBeAndItSaysSo) {
  constexpr std::uint64_t kLargest = 100'000;
  auto opened = SqliteInputLog::open(folder.path(), {"marvin", "comets 1"}, kLargest);
  ASSERT_TRUE(opened.has_value());
  std::string why;
  for (const node::LogEntry& entry : long_life(3000)) {
    const auto kept = opened->log->append(entry);
    if (!kept && why.empty()) why = kept.error().why;
  }

  EXPECT_THAT(why, HasSubstr("marvin.state: database or disk is full"));
  opened->log.reset();
  EXPECT_LE(fs::file_size(state()), kLargest + 4096);
  EXPECT_THAT(open().set_aside, HasSubstr("incomplete"));
}

}  // namespace
}  // namespace skein::store
