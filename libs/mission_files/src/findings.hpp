// SPDX-License-Identifier: Apache-2.0
// What a reading finds wrong, and what it leaves out.
#pragma once

#include <string>
#include <utility>

#include "skein/foundation/diagnostics.hpp"
#include "skein/mission_files/contents.hpp"

namespace skein::mission_files {

class Findings {
 public:
  explicit Findings(std::string file) : file_(std::move(file)) {}

  void wrong(const Mark& mark, std::string message, std::string expected = "") {
    wrong_.add({file_, mark.line, 0, mark.path, std::move(message), std::move(expected), ""});
  }
  void leave_out(const Mark& mark, std::string what) {
    left_out_.add({file_, mark.line, 0, mark.path, std::move(what), "", ""});
  }
  const std::string& file() const { return file_; }
  /// For readers that tell their errors themselves.
  Diagnostics& errors() { return wrong_; }
  bool none_wrong() const { return wrong_.empty(); }
  Diagnostics take_left_out() { return std::move(left_out_); }

 private:
  std::string file_;
  Diagnostics wrong_, left_out_;
};

}  // namespace skein::mission_files
