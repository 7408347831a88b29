// SPDX-License-Identifier: Apache-2.0
// Errors, omissions and assumptions of an import.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/mission_files/contents.hpp"

namespace skein::import_tool {

class Log {
 public:
  explicit Log(std::string file) : file_(std::move(file)) {}

  /// Said once where it is the same of all points of a way.
  void wrong(const mission_files::Mark& mark, std::string what, std::string expected = "") {
    const Diagnostic one{file_, mark.line, 0, mark.path, std::move(what), std::move(expected), ""};
    if (wrong_.empty() || wrong_.all().back() != one) wrong_.add(one);
  }
  void leave_out(const mission_files::Mark& mark, std::string what) {
    left_out_.add({file_, mark.line, 0, mark.path, std::move(what), "", ""});
  }
  void say(std::string what) { said_.push_back(std::move(what)); }

  const Diagnostics& errors() const { return wrong_; }
  const Diagnostics& left_out() const { return left_out_; }
  const std::vector<std::string>& said() const { return said_; }

 private:
  std::string file_;
  Diagnostics wrong_, left_out_;
  std::vector<std::string> said_;
};

}  // namespace skein::import_tool
