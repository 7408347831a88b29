// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/diagnostics.hpp"

#include "skein/foundation/nearest.hpp"
#include "skein/foundation/printable.hpp"

namespace skein {

void Diagnostics::append(const Diagnostics& others) {
  all_.insert(all_.end(), others.all_.begin(), others.all_.end());
}

std::string to_text(const Diagnostic& d) {
  std::string where = d.file;
  if (d.line > 0) {
    where += (where.empty() ? "line " : ":") + std::to_string(d.line);
    if (d.column > 0) where += ":" + std::to_string(d.column);
  }
  std::string text = where.empty() ? "" : where + ": ";
  if (!d.path.empty()) text += d.path + ": ";
  text += d.message;
  if (!d.expected.empty()) text += "; expected " + d.expected;
  return printable(text + did_you_mean(d.nearest));
}

std::string to_text(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics.all()) text += to_text(diagnostic) + "\n";
  return text;
}

}  // namespace skein
