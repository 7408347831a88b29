// SPDX-License-Identifier: Apache-2.0
#include "process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <deque>
#include <fstream>
#include <utility>

extern char** environ;

namespace skein::run_tool {

namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// Actions and attributes of posix_spawn: output to the log, own group, no blocked signals.
class SpawnSetup {
 public:
  explicit SpawnSetup(const std::string& log) {
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(),
                                     O_WRONLY | O_CREAT | O_APPEND, 0644);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
  }
  SpawnSetup(const SpawnSetup&) = delete;
  SpawnSetup& operator=(const SpawnSetup&) = delete;
  ~SpawnSetup() {
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
  }

  posix_spawn_file_actions_t actions{};
  posix_spawnattr_t attributes{};
};

// Without the variables of daemons (docs/daemons.md): who starts a run says what its daemons do.
std::vector<char*> environment_of_run() {
  std::vector<char*> kept;
  for (char** one = environ; *one != nullptr; ++one) {
    if (std::strncmp(*one, "SKEIN_", 6) != 0) kept.push_back(*one);
  }
  kept.push_back(nullptr);
  return kept;
}

}  // namespace

Result<Process, Failure> Process::start(const std::vector<std::string>& command,
                                        const std::string& log) {
  const SpawnSetup setup(log);
  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t pid = -1;
  const int error = posix_spawn(&pid, arguments[0], &setup.actions, &setup.attributes,
                                arguments.data(), environment_of_run().data());
  if (error != 0) return failure("cannot start " + command[0] + ": " + std::strerror(error));
  return Process(pid);
}

Process::Process(Process&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)), ended_(other.ended_) {}

Process& Process::operator=(Process&& other) noexcept {
  std::swap(pid_, other.pid_);
  std::swap(ended_, other.ended_);
  return *this;
}

Process::~Process() {
  if (pid_ < 0 || poll()) return;
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

std::optional<Process::Status> Process::poll() {
  if (ended_) return ended_;
  int status = 0;
  rusage usage{};
  if (wait4(pid_, &status, WNOHANG, &usage) != pid_) return std::nullopt;
  ended_ = Status{};
  if (WIFSIGNALED(status)) {
    ended_->signal = WTERMSIG(status);
  } else {
    ended_->code = WEXITSTATUS(status);
  }
  ended_->cpu = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  ended_->peak_memory = static_cast<double>(usage.ru_maxrss) / 1024;
  return ended_;
}

void Process::send(int signal) const {
  if (pid_ > 0 && !ended_) kill(pid_, signal);
}

std::string to_text(const Process::Status& status) {
  if (status.signal == 0) return "exit code " + std::to_string(status.code);
  return "signal " + std::to_string(status.signal) + " (" + strsignal(status.signal) + ")";
}

std::string tail_of(const std::string& file, std::size_t lines) {
  std::ifstream in(file);
  std::deque<std::string> last;
  for (std::string line; std::getline(in, line);) {
    last.push_back(line);
    if (last.size() > lines) last.pop_front();
  }
  std::string text;
  for (const std::string& line : last) text += "    " + line + "\n";
  return text;
}

}  // namespace skein::run_tool
