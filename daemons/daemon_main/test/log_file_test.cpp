// SPDX-License-Identifier: Apache-2.0
#include "log_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace skein::daemon_main {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class LogFiles : public ::testing::Test {
 protected:
  LogFiles() { std::filesystem::create_directories(folder_); }
  ~LogFiles() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string content(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("skein-log-file-" + std::to_string(getpid()));
};

TEST_F(LogFiles, EachLineIsThereAtOnceAndAfterWhatWasThereBefore) {
  std::ofstream(path("a")) << "before\n";

  auto log = LogFile::open(path("a"));
  ASSERT_TRUE(log.has_value());
  EXPECT_THAT(log->append("one"), IsEmpty());
  EXPECT_EQ(content("a"), "before\none\n");
  EXPECT_THAT(log->append("two"), IsEmpty());
  EXPECT_EQ(content("a"), "before\none\ntwo\n");
}

TEST_F(LogFiles, AfterAPieceOfALineItGoesOnWithAWholeOne) {
  std::ofstream(path("a")) << "before\ncut sh";

  auto log = LogFile::open(path("a"));
  ASSERT_TRUE(log.has_value());
  log->append("one");

  EXPECT_EQ(content("a"), "before\ncut sh\none\n");
}

TEST_F(LogFiles, IsAnotherOfItsNameOnceItWasRenamed) {
  std::ofstream(path("a")) << "before\n";
  auto log = LogFile::open(path("a"));
  ASSERT_TRUE(log.has_value());
  log->append("one");

  std::filesystem::rename(path("a"), path("a.1"));
  EXPECT_THAT(log->append("two"), IsEmpty());
  EXPECT_EQ(content("a.1"), "before\none\n");
  EXPECT_EQ(content("a"), "two\n");
  EXPECT_TRUE(log->had("before"));

  std::ofstream(path("a"), std::ios::trunc);
  EXPECT_THAT(log->append("three"), IsEmpty());
  EXPECT_EQ(content("a"), "three\n");
}

TEST_F(LogFiles, GoesOnWithTheOldOneWhereNoneOfItsNameCanBeMade) {
  std::filesystem::create_directory(path("folder"));
  auto log = LogFile::open(path("folder/a"));
  ASSERT_TRUE(log.has_value());
  log->append("one");

  std::filesystem::rename(path("folder"), path("moved"));
  EXPECT_THAT(log->append("two"), IsEmpty());
  EXPECT_EQ(content("moved/a"), "one\ntwo\n");
}

TEST_F(LogFiles, KnowsWhichLinesItHadInTheirOrder) {
  std::ofstream(path("a")) << "one\ntwo\nof the runtime\nthree\ncut sh";

  auto log = LogFile::open(path("a"));
  ASSERT_TRUE(log.has_value());
  EXPECT_TRUE(log->had("two"));
  EXPECT_TRUE(log->had("three"));
  EXPECT_FALSE(log->had("three")) << "it was there once";
  EXPECT_FALSE(log->had("cut short"));
  EXPECT_FALSE(log->had("one")) << "that was before";
  log->append("four");

  EXPECT_FALSE(log->had("four"));
  EXPECT_EQ(content("a"), "one\ntwo\nof the runtime\nthree\ncut sh\nfour\n");
}

TEST_F(LogFiles, AFileThatCannotBeWrittenIsNamed) {
  const auto log = LogFile::open(path("no/such/folder"));

  ASSERT_FALSE(log.has_value());
  EXPECT_THAT(log.error().why, HasSubstr("no/such/folder: No such file"));
}

// A file may become no greater than so much: as good as a full disk.
TEST_F(LogFiles, SaysOnceThatThereIsNoRoomAndOnceThatThereIsAgain) {
  auto log = LogFile::open(path("a"));
  ASSERT_TRUE(log.has_value());
  log->append("one");
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit narrow = before;
  narrow.rlim_cur = 6;
  setrlimit(RLIMIT_FSIZE, &narrow);

  const std::string full = log->append("three");
  const std::string still = log->append("four");
  setrlimit(RLIMIT_FSIZE, &before);
  const std::string again = log->append("five");

  EXPECT_THAT(full, HasSubstr("takes no more lines: File too large"));
  EXPECT_THAT(still, IsEmpty());
  EXPECT_THAT(again, HasSubstr("takes lines again; 2 are lost"));
  EXPECT_THAT(content("a"), ::testing::StartsWith("one\n"));
  EXPECT_THAT(content("a"), ::testing::EndsWith("\nfive\n"));
}

}  // namespace
}  // namespace skein::daemon_main
