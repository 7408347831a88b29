// SPDX-License-Identifier: Apache-2.0
// Errors in input files: all of them, each with its place and with what was expected.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace skein {

/// One error in an input file.
struct Diagnostic {
  std::string file;      ///< as the user named it; empty: standard input or no file
  int line = 0;          ///< from 1; 0: unknown
  int column = 0;        ///< from 1; 0: unknown
  std::string path;      ///< where in the document: "uavs.marvin.model"; may be empty
  std::string message;   ///< what is wrong: "unknown UAV 'marvn'"
  std::string expected;  ///< what would have been right; may be empty
  std::string nearest;   ///< the nearest valid name; may be empty
  bool operator==(const Diagnostic&) const = default;
};

/// All the errors of one reading, in the order found.
class Diagnostics {
 public:
  void add(Diagnostic diagnostic) { all_.push_back(std::move(diagnostic)); }
  void append(const Diagnostics& others);
  bool empty() const { return all_.empty(); }
  std::size_t size() const { return all_.size(); }
  const std::vector<Diagnostic>& all() const { return all_; }

 private:
  std::vector<Diagnostic> all_;
};

/// "file:line:column: path: message; expected …; did you mean 'nearest'?" — absent parts left out.
std::string to_text(const Diagnostic& diagnostic);

/// One line each, ended by a newline.
std::string to_text(const Diagnostics& diagnostics);

}  // namespace skein
