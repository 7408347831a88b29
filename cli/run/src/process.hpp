// SPDX-License-Identifier: Apache-2.0
// Child processes of a run.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/result.hpp"

namespace skein::run_tool {

/// A program running in a process group of its own, with its output appended to a log file. The
/// destructor kills and reaps it.
class Process {
 public:
  /// How it ended: an exit code, or a signal.
  struct Status {
    int code = 0;
    int signal = 0;          ///< 0: it exited by itself
    double cpu = 0;          ///< user and system time [s]
    double peak_memory = 0;  ///< greatest resident set [MB]
  };

  static Result<Process, Failure> start(const std::vector<std::string>& command,
                                        const std::string& log);
  Process(Process&& other) noexcept;
  Process& operator=(Process&& other) noexcept;
  ~Process();

  pid_t pid() const { return pid_; }
  /// The end of the process; nothing while it runs. Does not wait.
  std::optional<Status> poll();
  void send(int signal) const;

 private:
  explicit Process(pid_t pid) : pid_(pid) {}

  pid_t pid_ = -1;
  std::optional<Status> ended_;
};

/// "exit code 3", "signal 11 (Segmentation fault)".
std::string to_text(const Process::Status& status);

/// The last lines of a file, each indented; empty if there are none.
std::string tail_of(const std::string& file, std::size_t lines);

}  // namespace skein::run_tool
