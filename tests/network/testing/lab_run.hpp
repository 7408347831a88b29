// SPDX-License-Identifier: Apache-2.0
// `scripts/radio-lab` as a user starts it, with what it leaves behind.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "process.hpp"
#include "skein/journal/record.hpp"

namespace skein::testing {

namespace fs = std::filesystem;

/// Of one direction, from air.json.
struct Carried {
  double carried = 0, bytes = 0, lost = 0, cut = 0, overflowed = 0, pieces = 0;
};

class LabRun {
 public:
  LabRun();
  LabRun(const LabRun&) = delete;
  LabRun& operator=(const LabRun&) = delete;
  /// Shows what it said if the test failed, and takes it away.
  ~LabRun();

  /// `scenario`: below scenarios/, `faults`: below tests/network/faults/, both without ".yaml";
  /// `faults` may be empty.
  void start(const std::string& scenario, const std::string& faults,
             const std::vector<std::string>& options);
  /// Its exit code; nothing if it does not end in time.
  std::optional<int> wait(double seconds);
  /// Until this is in what it has said.
  bool says(const std::string& text, double seconds);
  void kill();
  /// Whether none of its processes is left then.
  bool ends_within(double seconds) const;

  pid_t pid() const { return process_->pid(); }
  std::string output() const;
  std::vector<journal::Record> records() const;
  /// Sums over both directions of all pairs.
  Carried carried() const;
  /// Processes on whose command line its folder is, but for itself.
  std::vector<pid_t> processes() const;
  fs::path out() const { return folder_ / "out"; }

 private:
  fs::path folder_;
  std::optional<run_tool::Process> process_;
};

}  // namespace skein::testing
