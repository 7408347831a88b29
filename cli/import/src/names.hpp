// SPDX-License-Identifier: Apache-2.0
// Names that scenarios take, each once.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace skein::import_tool {

/// Letters, digits, '-' and '_' of it, 32 at most; empty when nothing is left, or a word that YAML
/// takes for nothing.
std::string plain_name(std::string_view text);

class Names {
 public:
  void reserve(const std::string& name) { taken_.insert(name); }
  /// plain_name(text), or else `otherwise`, with a number behind it when it is taken or is no name
  /// of a place (mission::means_home).
  std::string make(std::string_view text, const std::string& otherwise);

 private:
  std::set<std::string> taken_;
};

}  // namespace skein::import_tool
