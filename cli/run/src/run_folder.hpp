// SPDX-License-Identifier: Apache-2.0
// The folder with the results of a run.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/journal/record.hpp"
#include "skein/report/journal.hpp"
#include "skein/report/run_info.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::run_tool {

/// Description of the run for the report, including the air that was closed.
report::RunInfo run_info(const scenario::Scenario& scenario, bool virtual_time, double wall_seconds,
                         const std::vector<journal::Record>& records = {});

/// A folder that is this run's alone as long as the object lives; the kernel gives it back when the
/// process ends, however.
class ClaimedFolder {
 public:
  /// None where another run has claimed it. A file system without locks claims nothing.
  static std::optional<ClaimedFolder> claim(const std::string& folder);
  ClaimedFolder(ClaimedFolder&& other) noexcept
      : descriptor_(std::exchange(other.descriptor_, -1)) {}
  ClaimedFolder& operator=(ClaimedFolder&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~ClaimedFolder();

 private:
  explicit ClaimedFolder(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

/// Creates the folder (and its parents) if needed, claims it, and empties it of the results of an
/// earlier run. A run that goes on there is a failure, and keeps what it has.
Result<ClaimedFolder, Failure> prepare_folder(const std::string& folder);

/// Writes events.jsonl, run.json, scenario.yaml (a copy that can be run from there: names of files
/// lead to where they are), and from them report.html, junit.xml and result.json. Gives the text of
/// result.json. `text` is that of the scenario, if it is not the one in its file.
Result<std::string, Failure> write_folder(const std::string& folder,
                                          const scenario::Scenario& scenario,
                                          const report::RunInfo& info,
                                          const std::vector<journal::Record>& records,
                                          const std::optional<std::string>& text = {});

/// Writes report.html, junit.xml and result.json from events.jsonl and run.json.
Result<std::string, Failure> write_report(const std::string& folder);

/// The event log of a folder, without the lines that cannot be read.
Result<report::Journal, Failure> read_run_journal(const std::string& folder);

}  // namespace skein::run_tool
