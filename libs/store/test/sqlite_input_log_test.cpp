// SPDX-License-Identifier: Apache-2.0
#include "skein/store/sqlite_input_log.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "database.hpp"
#include "skein/blackboard/cdr.hpp"
#include "testing/entries.hpp"

namespace skein::store {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::one_of_each;

std::vector<std::string> texts(const node::InputLog& log) {
  std::vector<std::string> found;
  const auto read = log.recall([&](const node::LogEntry& entry) -> Result<void, Failure> {
    found.push_back(testing::to_text(entry));
    return {};
  });
  if (!read) found.push_back("FAILED " + read.error().why);
  return found;
}

std::vector<std::string> texts(const std::vector<node::LogEntry>& entries) {
  std::vector<std::string> found;
  for (const node::LogEntry& entry : entries) found.push_back(testing::to_text(entry));
  return found;
}

class StateOnDisk : public ::testing::Test {
 protected:
  Opened open(const Identity& identity = {"marvin", "comets 1"}) {
    auto opened = SqliteInputLog::open(folder.path(), identity);
    if (!opened) throw std::runtime_error(opened.error().why);
    return std::move(*opened);
  }
  /// A life that is given one of each and dies.
  void live() {
    const Opened life = open();
    for (const node::LogEntry& entry : one_of_each()) {
      const auto kept = life.log->append(entry);
      ASSERT_TRUE(kept.has_value()) << kept.error().why;
    }
    life.log->told(12);
  }
  fs::path state() const { return folder.path() / "marvin.state"; }

  testing::Folder folder;
};

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

std::vector<std::string> texts_of_lives(const node::InputLog& log) {
  std::vector<std::string> found;
  const auto read = log.recall_lives([&](const node::LogEntry& entry) -> Result<void, Failure> {
    found.push_back(testing::to_text(entry));
    return {};
  });
  if (!read) found.push_back("FAILED " + read.error().why);
  return found;
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

/// What a program of version 1 to 3 left, by its own tables.
void leave_version(int version, const fs::path& state) {
  SQLite::Database old(state.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  old.exec(std::string(
               "CREATE TABLE about (what TEXT PRIMARY KEY, value) WITHOUT ROWID;"
               "CREATE TABLE inputs (number INTEGER PRIMARY KEY, at INTEGER NOT NULL, kind TEXT "
               "NOT NULL,"
               "  peer INTEGER NOT NULL, slot TEXT NOT NULL, value INTEGER NOT NULL, extra INTEGER "
               "NOT NULL,"
               "  flags INTEGER NOT NULL, body BLOB NOT NULL);"
               "INSERT INTO about VALUES ('node', 'marvin'), ('mission', 'comets 1'), ('lines', 7);"
               "INSERT INTO inputs (at, kind, peer, slot, value, extra, flags, body) VALUES"
               "  (0, 'started', 0, '', 5, 0, 0, x''), (1000, 'wakeup', 0, '', 0, 0, 0, x'');") +
           "PRAGMA user_version = " + std::to_string(version));
  std::ofstream(fs::path(state).replace_extension("complete")).put('\n');
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
}

TEST_F(StateOnDisk, WhereNothingCanBeWrittenSaysSo) {
  std::ofstream(folder.path() / "occupied").put('x');

  const auto opened = SqliteInputLog::open(folder.path() / "occupied", {"marvin", "comets 1"});

  ASSERT_FALSE(opened.has_value());
  EXPECT_THAT(opened.error().why, HasSubstr("occupied/marvin.lock: Not a directory"));
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

TEST_F(StateOnDisk, ADamagedInputIsNamed) {
  live();
  SQLite::Database(state().string(), SQLite::OPEN_READWRITE)
      .exec("UPDATE inputs SET slot = 'Gossip' WHERE number = 3");

  EXPECT_THAT(texts(*open().log).back(), HasSubstr("marvin.state: input 3: not what was written"));
}

// ---- what is not the last is folded ----

/// A long life: telemetry with a plan board now and then.
std::vector<node::LogEntry> long_life(int inputs) {
  std::vector<node::LogEntry> life{{MissionTime(), node::Started{1}}};
  wire::Telemetry telemetry;
  telemetry.uav = "marvin";
  wire::PlanBoard board;
  for (std::uint64_t id = 1; id <= 30; ++id) board.tasks.push_back({id, "goto", {}, ""});
  for (int i = 1; i < inputs; ++i) {
    const MissionTime at = MissionTime::seconds(i);
    telemetry.position.x = 0.3 * i;
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

TEST_F(StateOnDisk, ALongLifeIsKeptInItsOrderAndGoneOnFrom) {
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

TEST_F(StateOnDisk, ALongLifeOfVersion3IsFoldedWhenItIsOpened) {
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

TEST_F(StateOnDisk, AnInputThatIsMissingIsNamed) {
  {
    const Opened life = open();
    for (const node::LogEntry& entry : long_life(5000)) ASSERT_TRUE(life.log->append(entry));
  }
  SQLite::Database(state().string(), SQLite::OPEN_READWRITE).exec("DELETE FROM folds");

  EXPECT_EQ(texts(*open().log).back(), "FAILED " + state().string() + ": input 1: missing");
}

// A disk that gives back other bytes than it took is found out, whichever they are: never another
// input, never a crash.
TEST_F(StateOnDisk, AByteThatIsAnotherNeverMakesAnotherInput) {
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

TEST_F(StateOnDisk, AFileIsNeverLargerThanItMayBeAndItSaysSo) {
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

// ---- a disk that is full for a time ----

/// Files may not grow beyond this for as long as it lives: SQLite sees a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

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
