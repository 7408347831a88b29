// SPDX-License-Identifier: Apache-2.0
// The event log of a node as a file of its machine.
#pragma once

#include <string>
#include <string_view>

#include "skein/foundation/result.hpp"

namespace skein::daemon_main {

/// Lines at the end of a file, each in the hands of the system when append() returns, so that what
/// ends the process loses none. A line that found no room is lost, as a whole: the file goes on
/// with a whole line. Thread rule: one thread.
class LogFile {
 public:
  /// Makes the file, or goes on at its end. The failure names it and says why not.
  static Result<LogFile, Failure> open(const std::string& path);
  LogFile(LogFile&& other) noexcept;
  LogFile& operator=(LogFile&& other) noexcept;
  ~LogFile();

  /// Without its end of line. What may be told of how it went, once for each change: why lines are
  /// lost from now on, or that they are not any more and how many were; else empty.
  std::string append(std::string_view line);

 private:
  LogFile(std::string path, int file, bool torn)
      : path_(std::move(path)), file_(file), torn_(torn) {}
  bool put(std::string_view text);

  std::string path_;
  int file_ = -1;
  bool torn_ = false;  ///< it ends within a line
  std::size_t lost_ = 0;
};

}  // namespace skein::daemon_main
