// SPDX-License-Identifier: Apache-2.0
// The event log of a node as a local file.
#pragma once

#include <sys/types.h>

#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "skein/foundation/result.hpp"

namespace skein::daemon_main {

/// Appends lines to a file. Each has been passed to the operating system when append() returns, so
/// no line is lost if the process ends. A line that could not be written completely (disk full) is
/// lost as a whole, and the next one begins on a new line. Once the file was renamed or removed (by
/// who rotates logs) the next line begins another one of its name; where none can be made it goes
/// on with the old one. Thread rule: one thread.
class LogFile {
 public:
  /// Creates the file, or opens it for appending. The failure has the path and the reason.
  static Result<LogFile, Failure> open(const std::string& path);
  LogFile(LogFile&& other) noexcept;
  LogFile& operator=(LogFile&& other) noexcept;
  ~LogFile();

  /// Appends a line, given without its end of line. Returns a notice when the state changes: the
  /// reason why lines are lost from now on, or the number of lost lines after recovery; else empty.
  std::string append(std::string_view line);
  /// Whether this line is among the last of those that the file had when it was opened (1 MB),
  /// behind the one of the last such question that was answered with yes. So the lines with which a
  /// process ended that was killed are told from those that it had still to write.
  bool had(std::string_view line);

 private:
  LogFile(std::string path, int file, bool torn);
  bool put(std::string_view text);
  /// Another file of its name, unless it has it still.
  void follow_name();

  std::string path_;
  int file_ = -1;
  bool torn_ = false;  ///< the file ends within a line
  std::size_t lost_ = 0;
  off_t size_before_ = 0;  ///< [bytes] when it was opened
  /// The last lines that it had then; read when somebody asks for one, which few lives do.
  std::optional<std::deque<std::string>> before_;
};

}  // namespace skein::daemon_main
