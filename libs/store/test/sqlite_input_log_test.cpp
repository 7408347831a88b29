// SPDX-License-Identifier: Apache-2.0
#include "skein/store/sqlite_input_log.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "skein/blackboard/cdr.hpp"
#include "testing/full_disk.hpp"
#include "testing/state_on_disk.hpp"

namespace skein::store {
namespace {

namespace fs = std::filesystem;
using testing::FullDisk;
using ::testing::HasSubstr;
using testing::leave_version;
using testing::one_of_each;
using testing::StateOnDisk;
using testing::texts;
using testing::texts_of_lives;

TEST_F(StateOnDisk, ANewOneIsEmpty) {
  const Opened opened = open();

  EXPECT_EQ(opened.set_aside, "");
  EXPECT_TRUE(texts(*opened.log).empty());
  EXPECT_EQ(opened.log->lines_told(), 0U);
}

TEST_F(StateOnDisk, TheNextLifeKnowsAllThatTheLastOneWasGivenInItsOrder) {
  live();

  const Opened next = open();

  EXPECT_EQ(next.set_aside, "");
  EXPECT_EQ(texts(*next.log), texts(one_of_each()));
  EXPECT_EQ(next.log->lines_told(), 12U);
}

TEST_F(StateOnDisk, ItsLivesAreThoseThatAMemoryOfTheSameInputsHas) {
  live();
  live();
  node::MemoryInputLog memory;
  for (int life = 0; life < 2; ++life)
    for (const node::LogEntry& entry : one_of_each()) ASSERT_TRUE(memory.append(entry));

  const std::vector<std::string> lives = texts_of_lives(*open().log);

  EXPECT_EQ(lives.size(), 6U);  // each life: started, resumed, one that was not sent
  EXPECT_EQ(lives, texts_of_lives(memory));
}

TEST_F(StateOnDisk, ItsLivesBeginWithItsFirstInputWhateverThatIs) {
  ASSERT_TRUE(open().log->append({MissionTime(), node::Wakeup{}}));

  EXPECT_EQ(texts_of_lives(*open().log),
            texts(std::vector<node::LogEntry>{{MissionTime(), node::Wakeup{}}}));
}

int version_of(const fs::path& state) {
  SQLite::Database file(state.string());
  return file.execAndGet("PRAGMA user_version").getInt();
}

class StateOfBefore : public StateOnDisk, public ::testing::WithParamInterface<int> {};

TEST_P(StateOfBefore, IsBroughtUpAndGoneOnFrom) {
  leave_version(GetParam(), state());
  {
    const Opened next = open();
    EXPECT_EQ(next.set_aside, "");
    EXPECT_EQ(texts(*next.log).size(), 2U);
    EXPECT_EQ(next.log->lines_told(), 7U);
    ASSERT_TRUE(next.log->append({MissionTime::seconds(2), node::Wakeup{}}));
  }
  EXPECT_EQ(version_of(state()), 4);
  EXPECT_EQ(texts(*open().log).size(), 3U);
}

INSTANTIATE_TEST_SUITE_P(Versions, StateOfBefore, ::testing::Values(1, 2, 3));

TEST_F(StateOnDisk, WhatIsLikeWhatCameBeforeTakesLittleRoom) {
  constexpr int kBoards = 200;
  wire::PlanBoard board;
  for (std::uint64_t id = 1; id <= 60; ++id) board.tasks.push_back({id, "goto", {}, ""});
  std::size_t bytes = 0;
  {
    const Opened opened = open();
    ASSERT_TRUE(opened.log->append({MissionTime(), node::Started{1}}));
    for (int i = 0; i < kBoards; ++i) {
      board.tasks[static_cast<std::size_t>(i % 60)].id += 1000;
      bytes += blackboard::encoded_size(board);
      ASSERT_TRUE(opened.log->append(
          {MissionTime::seconds(i), node::Received{node::NodeNumber(2), board}}));
    }
    EXPECT_EQ(texts(*opened.log).size(), kBoards + 1U);
  }
  EXPECT_LT(fs::file_size(state()), bytes / 6);
}

TEST_F(StateOnDisk, WhatAProgramWithOtherMessagesLeftIsSetAsideAndItSaysSo) {
  live();
  {
    SQLite::Database file(state().string(), SQLite::OPEN_READWRITE);
    file.exec("UPDATE about SET value = '0123456789abcdef' WHERE what = 'messages'");
    ASSERT_EQ(file.getChanges(), 1);
  }

  const Opened next = open();

  EXPECT_THAT(next.set_aside, HasSubstr("of a program with other messages (0123456789abcdef, "));
  EXPECT_TRUE(texts(*next.log).empty());
}

TEST_F(StateOnDisk, LivesFollowEachOther) {
  live();
  ASSERT_TRUE(open().log->append({MissionTime::seconds(900), node::Resumed{}}));

  EXPECT_EQ(texts(*open().log).size(), one_of_each().size() + 1);
}

TEST_F(StateOnDisk, WhatWasAppendedIsThereHoweverTheProcessDies) {
  const pid_t child = fork();
  if (child == 0) {
    const Opened life = open();
    for (const node::LogEntry& entry : one_of_each()) (void)life.log->append(entry);
    raise(SIGKILL);
  }
  waitpid(child, nullptr, 0);

  EXPECT_EQ(texts(*open().log), texts(one_of_each()));
}

TEST_F(StateOnDisk, TwoNodesShareAFolder) {
  const Opened marvin = open();
  const Opened karma = open({"karma", "comets 1"});

  ASSERT_TRUE(marvin.log->append({MissionTime(), node::Started{1}}));

  EXPECT_TRUE(texts(*karma.log).empty());
}

TEST_F(StateOnDisk, IsOfOneProcessAtATime) {
  const Opened first = open();

  const auto second = SqliteInputLog::open(folder.path(), {"marvin", "comets 1"});

  ASSERT_FALSE(second.has_value());
  EXPECT_THAT(second.error().why, HasSubstr("marvin.state: another process uses it"));
  EXPECT_TRUE(second.error().in_use);
}

TEST_F(StateOnDisk, WhereNothingCanBeWrittenSaysSo) {
  std::ofstream(folder.path() / "occupied").put('x');

  const auto opened = SqliteInputLog::open(folder.path() / "occupied", {"marvin", "comets 1"});

  ASSERT_FALSE(opened.has_value());
  EXPECT_THAT(opened.error().why, HasSubstr("occupied/marvin.lock: Not a directory"));
  EXPECT_FALSE(opened.error().in_use);
}

// ---- what is not gone on from ----

class SetAside : public StateOnDisk {
 protected:
  /// Opens what is there and expects it to be set aside for that reason, and a new one begun.
  void expect_aside(const std::string& why, const Identity& identity = {"marvin", "comets 1"}) {
    const Opened opened = open(identity);
    EXPECT_THAT(opened.set_aside, HasSubstr(state().string() + " is " + why));
    EXPECT_THAT(opened.set_aside, HasSubstr("marvin.state.aside-1"));
    EXPECT_TRUE(fs::exists(state().string() + ".aside-1"));
    EXPECT_TRUE(texts(*opened.log).empty());
    EXPECT_TRUE(opened.log->append({MissionTime(), node::Started{1}}));
  }
};

TEST_F(SetAside, AnotherScenarios) {
  live();
  expect_aside("of another scenario", {"marvin", "comets 2"});
}

TEST_F(SetAside, AnotherScenariosIsTakenBackAsItWas) {
  live();
  {
    const Opened opened = open({"marvin", "comets 2"});
    ASSERT_TRUE(opened.log->append({MissionTime(), node::Started{7}}));
    EXPECT_TRUE(opened.log->take_back());
  }
  const Opened next = open();
  EXPECT_EQ(next.set_aside, "");
  EXPECT_EQ(texts(*next.log), texts(one_of_each()));
  EXPECT_FALSE(fs::exists(state().string() + ".aside-1"));
}

TEST_F(SetAside, NothingElseIsTakenBack) {
  EXPECT_FALSE(open().log->take_back());
  live();
  EXPECT_FALSE(open().log->take_back());
  fs::remove(folder.path() / "marvin.complete");
  EXPECT_FALSE(open({"marvin", "comets 2"}).log->take_back());
}

TEST_F(SetAside, AnotherNodes) {
  live();
  for (const char* part : {".state", ".state-wal"}) {
    std::error_code missing;
    fs::rename(folder.path() / (std::string("marvin") + part),
               folder.path() / (std::string("karma") + part), missing);
  }

  const Opened opened = open({"karma", "comets 1"});

  EXPECT_THAT(opened.set_aside, HasSubstr("karma.state is of node 'marvin'"));
}

TEST_F(SetAside, OneOfAMissionThatIsOver) {
  live();
  open().log->conclude();
  expect_aside("of a mission that is over");
}

TEST_F(SetAside, OneThatMissesSomething) {
  live();
  fs::remove(folder.path() / "marvin.complete");
  expect_aside("incomplete");
}

TEST_F(SetAside, OneOfANewerVersion) {
  live();
  SQLite::Database(state().string(), SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 99");
  expect_aside("of version 99, this program reads up to 4");
}

TEST_F(SetAside, HalfAFile) {
  live();
  SQLite::Database(state().string(), SQLite::OPEN_READWRITE)
      .exec("PRAGMA wal_checkpoint(TRUNCATE)");
  fs::resize_file(state(), fs::file_size(state()) / 2);
  expect_aside("damaged");
}

TEST_F(SetAside, AFileOfSomethingElse) {
  std::ofstream(state()) << std::string(5000, 'x');
  expect_aside("damaged");
}

TEST_F(SetAside, NoneIsOverwritten) {
  for (int i = 1; i <= 3; ++i) {
    std::ofstream(state()) << std::string(5000, 'x');
    EXPECT_THAT(open().set_aside, HasSubstr("aside-" + std::to_string(i)));
  }
}

TEST_F(SetAside, OnlyTheLastAreKeptAndItSaysWhichIsNot) {
  for (std::size_t i = 1; i <= SqliteInputLog::kSetAside; ++i) {
    std::ofstream(state()) << std::string(5000, 'x');
    EXPECT_THAT(open().set_aside, ::testing::Not(HasSubstr("removed")));
  }
  std::ofstream(state()) << std::string(5000, 'x');

  EXPECT_THAT(open().set_aside, HasSubstr("marvin.state.aside-6 now, and " + state().string() +
                                          ".aside-1 is removed, since the last 5 are kept"));
  EXPECT_FALSE(fs::exists(state().string() + ".aside-1"));
  for (int i = 2; i <= 6; ++i)
    EXPECT_TRUE(fs::exists(state().string() + ".aside-" + std::to_string(i))) << i;
}

TEST_F(SetAside, WhatOnlyLooksLikeOneIsLeftAlone) {
  for (const char* name : {"marvin.state.aside-mine", "marvin.state.aside-7b", "notes"})
    std::ofstream(folder.path() / name).put('x');
  for (int i = 0; i < 8; ++i) {
    std::ofstream(state()) << std::string(5000, 'x');
    (void)open();
  }

  EXPECT_THAT(folder.names(), HasSubstr("marvin.state.aside-7b marvin.state.aside-8 "
                                        "marvin.state.aside-mine notes"));
}

TEST_F(SetAside, OneThatTheNodeCannotHaveHad) {
  live();
  const Opened opened = open();

  const auto aside = opened.log->start_anew();

  ASSERT_TRUE(aside.has_value());
  EXPECT_THAT(*aside, HasSubstr("marvin.state.aside-1"));
  EXPECT_TRUE(texts(*opened.log).empty());
}

/// SQL that makes another value of each column.
const std::vector<std::string>& other_values() {
  static const std::vector<std::string> changes = {
      "at = at + 1",       "kind = kind || 'x'",
      "peer = peer + 1",   "slot = slot || 'x'",
      "value = value + 1", "extra = extra + 1",
      "flags = flags + 1", "body = zeroblob(length(body) + 1)"};
  return changes;
}

TEST_F(StateOnDisk, EveryInputOfWhichAnyValueIsAnotherIsNamed) {
  live();
  const std::size_t inputs = texts(*open().log).size();
  for (std::size_t number = 1; number <= inputs; ++number)
    for (const std::string& change : other_values()) {
      const std::string here = " WHERE number = " + std::to_string(number);
      SQLite::Database file(state().string(), SQLite::OPEN_READWRITE);
      file.exec("CREATE TABLE before AS SELECT * FROM inputs" + here);
      file.exec("UPDATE inputs SET " + change + here);

      EXPECT_THAT(
          texts(*open().log).back(),
          HasSubstr("marvin.state: input " + std::to_string(number) + ": not what was written"))
          << change;

      file.exec("INSERT OR REPLACE INTO inputs SELECT * FROM before; DROP TABLE before");
    }
}

// ---- a disk that is full for a time ----

TEST_F(StateOnDisk, AFullDiskIsSaidAndNothingIsGoneOnFromThatMissesWhatCame) {
  {
    const Opened life = open();
    ASSERT_TRUE(life.log->append({MissionTime(), node::Started{1}}));
    const FullDisk full(1);
    const auto kept = life.log->append({MissionTime::seconds(1), node::Wakeup{}});
    ASSERT_FALSE(kept.has_value());
    EXPECT_THAT(kept.error().why, HasSubstr("marvin.state: "));
  }

  EXPECT_THAT(open().set_aside, HasSubstr("incomplete"));
}

TEST_F(StateOnDisk, OnceTheDiskHasRoomAgainNothingIsMissing) {
  {
    const Opened life = open();
    ASSERT_TRUE(life.log->append({MissionTime(), node::Started{1}}));
    {
      const FullDisk full(1);
      ASSERT_FALSE(life.log->append({MissionTime::seconds(1), node::Wakeup{}}));
      ASSERT_FALSE(life.log->append({MissionTime::seconds(2), node::Wakeup{}}));
    }
    ASSERT_TRUE(life.log->append({MissionTime::seconds(3), node::Wakeup{}}));
  }

  const Opened next = open();

  EXPECT_EQ(next.set_aside, "");
  EXPECT_EQ(texts(*next.log).size(), 4U);
}

}  // namespace
}  // namespace skein::store
