// SPDX-License-Identifier: Apache-2.0
#include "process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <utility>

#include "testing/scenario_copy.hpp"

namespace skein::run_tool {
namespace {

using testing::Folder;
using testing::read_text;

Process shell(const std::string& script, const std::string& log) {
  auto process = Process::start({"/bin/sh", "-c", script}, log);
  if (!process) ADD_FAILURE() << process.error().why;
  return std::move(*process);
}

// Blocks until the child has ended, without reaping it.
void await_end(const Process& process) {
  siginfo_t info{};
  EXPECT_EQ(waitid(P_PID, static_cast<id_t>(process.pid()), &info, WEXITED | WNOWAIT), 0);
}

bool exists(pid_t pid) { return kill(pid, 0) == 0 || errno != ESRCH; }

TEST(Process, TellsTheExitCodeOnceItHasEnded) {
  const Folder folder;
  Process process = shell("exit 7", folder / "log");
  await_end(process);

  const auto status = process.poll();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 7);
  EXPECT_EQ(status->signal, 0);
  EXPECT_EQ(to_text(*status), "exit code 7");
}

TEST(Process, TellsTheSameEndAgain) {
  const Folder folder;
  Process process = shell("exit 7", folder / "log");
  await_end(process);
  (void)process.poll();

  ASSERT_TRUE(process.poll().has_value());
  EXPECT_EQ(process.poll()->code, 7);
}

TEST(Process, TellsTheSignalThatEndedIt) {
  const Folder folder;
  Process process = shell("sleep 600", folder / "log");
  EXPECT_FALSE(process.poll().has_value());

  process.send(SIGKILL);
  await_end(process);

  ASSERT_TRUE(process.poll().has_value());
  EXPECT_EQ(process.poll()->signal, SIGKILL);
  EXPECT_THAT(to_text(*process.poll()), ::testing::StartsWith("signal 9 ("));
}

TEST(Process, AppendsItsOutputAndErrorsToTheLog) {
  const Folder folder;
  testing::write_text(folder / "log", "before\n");
  Process process = shell("echo out; echo err >&2", folder / "log");

  await_end(process);

  EXPECT_EQ(read_text(folder / "log"), "before\nout\nerr\n");
}

TEST(Process, ReadsNothing) {
  const Folder folder;
  Process process = shell("cat; echo done", folder / "log");

  await_end(process);

  EXPECT_EQ(read_text(folder / "log"), "done\n");
}

// Ctrl-C at the terminal goes to the runner alone, which then ends its daemons in order.
TEST(Process, IsInAProcessGroupOfItsOwn) {
  const Folder folder;
  const Process process = shell("sleep 600", folder / "log");

  EXPECT_EQ(getpgid(process.pid()), process.pid());
  EXPECT_NE(getpgid(process.pid()), getpgrp());
}

TEST(Process, DoesNotInheritBlockedSignals) {
  const Folder folder;
  sigset_t term;
  sigset_t before;
  sigemptyset(&term);
  sigaddset(&term, SIGTERM);
  sigprocmask(SIG_BLOCK, &term, &before);
  Process process = shell("exec sleep 600", folder / "log");
  sigprocmask(SIG_SETMASK, &before, nullptr);

  process.send(SIGTERM);
  await_end(process);

  EXPECT_EQ(process.poll()->signal, SIGTERM);
}

TEST(Process, IsKilledAndReapedWhenItGoesOutOfScope) {
  const Folder folder;
  pid_t pid = -1;

  {
    const Process process = shell("exec sleep 600", folder / "log");
    pid = process.pid();
    EXPECT_TRUE(exists(pid));
  }

  EXPECT_FALSE(exists(pid));
}

TEST(Process, AMovedOneIsNotKilledByWhatItWasMovedFrom) {
  const Folder folder;
  std::optional<Process> first = shell("exec sleep 600", folder / "log");
  const pid_t pid = first->pid();

  Process second = std::move(*first);
  first.reset();

  EXPECT_EQ(second.pid(), pid);
  EXPECT_FALSE(second.poll().has_value());
}

TEST(Process, AProgramThatIsNotThereIsAFailureThatNamesIt) {
  const Folder folder;

  const auto process = Process::start({"/no/such/skein-ddn"}, folder / "log");

  ASSERT_FALSE(process.has_value());
  EXPECT_THAT(process.error().why, ::testing::HasSubstr("/no/such/skein-ddn"));
}

TEST(Process, ASignalToOneThatHasEndedIsHarmless) {
  const Folder folder;
  Process process = shell("exit 0", folder / "log");
  await_end(process);
  (void)process.poll();

  EXPECT_NO_FATAL_FAILURE(process.send(SIGTERM));
}

TEST(TailOf, GivesTheLastLinesIndented) {
  const Folder folder;
  testing::write_text(folder / "log", "one\ntwo\nthree\n");

  EXPECT_EQ(tail_of((folder / "log").string(), 2), "    two\n    three\n");
}

TEST(TailOf, GivesAllOfAShortFileAndNothingOfNone) {
  const Folder folder;
  testing::write_text(folder / "log", "one, without its end");

  EXPECT_EQ(tail_of((folder / "log").string(), 5), "    one, without its end\n");
  EXPECT_EQ(tail_of((folder / "none").string(), 5), "");
}

}  // namespace
}  // namespace skein::run_tool
