// SPDX-License-Identifier: Apache-2.0
// Inputs of every kind, and a folder of its own for each test.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "skein/node/input_log.hpp"
#include "temporary_folder.hpp"

namespace skein::store::testing {

/// One of each kind, a sample of each slot among them, all with fields that are not at their
/// defaults.
std::vector<node::LogEntry> one_of_each();
/// What two entries are compared by.
std::string to_text(const node::LogEntry& entry);

/// Removed with what is in it at the end.
class Folder {
 public:
  const std::filesystem::path& path() const { return folder_.path(); }
  /// Names of the files in it, in their order, each followed by a blank.
  std::string names() const;

 private:
  skein::testing::TemporaryFolder folder_;
};

}  // namespace skein::store::testing
