// SPDX-License-Identifier: Apache-2.0
#include "skein/workers/workers.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace skein::workers {

namespace {

struct Child {
  std::uint64_t number = 0;
  pid_t pid = -1;
  int pipe = -1;
  std::string text;
};

void write_all(int to, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t n = ::write(to, text.data() + done, text.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return;
    done += static_cast<std::size_t>(n);
  }
}

Child start(std::uint64_t number, const Work& work, const Limits& limits) {
  int ends[2];
  if (::pipe(ends) != 0) std::abort();
  std::fflush(nullptr);
  const pid_t pid = ::fork();
  if (pid < 0) std::abort();
  if (pid == 0) {
    ::close(ends[0]);
    // The machine may do much else: the time is the process's own.
    const itimerval patience{{}, {limits.patience, 0}};
    ::setitimer(ITIMER_PROF, &patience, nullptr);
    write_all(ends[1], work());
    ::_exit(0);
  }
  ::close(ends[1]);
  return {number, pid, ends[0], ""};
}

// Reads what there is; false when the child has said all.
bool read_some(Child& child) {
  char buffer[4096];
  const ssize_t n = ::read(child.pipe, buffer, sizeof buffer);
  if (n < 0 && errno == EINTR) return true;
  if (n <= 0) return false;
  child.text.append(buffer, static_cast<std::size_t>(n));
  return true;
}

Outcome finish(Child& child, const Limits& limits) {
  int status = 0;
  ::close(child.pipe);
  while (::waitpid(child.pid, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFSIGNALED(status) && WEXITSTATUS(status) == 0)
    return {Outcome::End::kDone, std::move(child.text), ""};
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGPROF) {
    return {Outcome::End::kHung, std::move(child.text),
            "not done after " + std::to_string(limits.patience) + " s of processor time"};
  }
  return {Outcome::End::kDied, std::move(child.text),
          "the process died: " + std::string(signal != 0 ? strsignal(signal) : "exit")};
}

}  // namespace

void do_apart(const std::function<std::optional<Work>()>& next, const Limits& limits,
              const std::function<void(std::uint64_t number, const Outcome&)>& tell) {
  std::vector<Child> running;
  std::uint64_t given = 0;
  bool more = true;
  while (more || !running.empty()) {
    while (more && running.size() < static_cast<std::size_t>(limits.jobs)) {
      const auto work = next();
      more = work.has_value();
      if (more) running.push_back(start(given++, *work, limits));
    }
    std::vector<pollfd> ends;
    for (const Child& child : running) ends.push_back({child.pipe, POLLIN, 0});
    if (ends.empty()) break;
    if (::poll(ends.data(), ends.size(), -1) < 0) continue;
    for (std::size_t i = ends.size(); i-- > 0;) {
      if (ends[i].revents == 0 || read_some(running[i])) continue;
      const Outcome outcome = finish(running[i], limits);
      const std::uint64_t number = running[i].number;
      running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
      tell(number, outcome);
    }
  }
}

Outcome do_apart(const Work& work, const Limits& limits) {
  Child child = start(0, work, limits);
  while (read_some(child)) {
  }
  return finish(child, limits);
}

}  // namespace skein::workers
