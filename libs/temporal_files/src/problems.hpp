// SPDX-License-Identifier: Apache-2.0
// The errors and warnings of one reading as they are found: bounded in number, printable whatever
// the input.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/diagnostics.hpp"

namespace skein::temporal {

/// A position in a file. Zero and empty: unknown.
struct Place {
  int line = 0;
  int column = 0;
  std::string path;
};

class Problems {
 public:
  /// More errors than this are only announced.
  static constexpr std::size_t kMost = 100;

  explicit Problems(std::string file) : file_(std::move(file)) {}

  void add(const Place& place, std::string message, std::string expected = "",
           std::string nearest = "");
  /// As add(), and offers the nearest of the candidates. (Only the first errors and only among a
  /// bounded number of candidates, so that a wrong file costs no more than a right one.)
  void add_unknown(const Place& place, std::string_view kind, std::string_view name,
                   const std::vector<std::string>& candidates);

  /// Adds a warning about content that is read, but possibly not as intended. At most as many as
  /// errors.
  void warn(const Place& place, std::string message);

  bool none() const { return found_.empty(); }
  /// Whether there are so many errors that reading should stop.
  bool full() const { return full_; }
  Diagnostics take() { return std::move(found_); }
  Diagnostics take_warnings() { return std::move(warnings_); }

 private:
  std::string file_;
  Diagnostics found_;
  Diagnostics warnings_;
  std::size_t searches_ = 0;
  bool full_ = false;
};

/// The text in single quotes, shortened if long, with '?' for characters unsafe on a terminal.
std::string in_quotes(std::string_view text);

/// Why a text cannot be the name of a node or agent; empty when it can. Names are UTF-8 without
/// control characters and noncharacters, 1 to 256 bytes.
std::string name_problem(std::string_view text);

}  // namespace skein::temporal
