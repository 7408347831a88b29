// SPDX-License-Identifier: Apache-2.0
#include "over_dds.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "skein/foundation/exit_code.hpp"
#include "skein/run_tool/run.hpp"
#include "skein/scenario_text/scenario_text.hpp"
#include "skein/storm_tool/recorded.hpp"

namespace skein::storm_tool {

namespace {

namespace fs = std::filesystem;

/// The folder of one run: kept, or gone when it has been judged.
class Folder {
 public:
  Folder(const std::string& keep, const std::string& name)
      : kept_(!keep.empty()),
        path_(kept_ ? fs::path(keep) / name
                    : fs::temp_directory_path() / ("skein-storm-" + std::to_string(getpid()))) {
    fs::create_directories(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code none;
    if (!kept_) fs::remove_all(path_, none);
  }
  const fs::path& path() const { return path_; }

 private:
  bool kept_;
  fs::path path_;
};

std::string file_of(const Case& one, const fs::path& folder) {
  const std::string file = (folder / "drawn.yaml").string();
  std::ofstream(file) << scenario_text::moved(
      one.yaml, fs::absolute(one.file).parent_path().string(), folder.string());
  return file;
}

// Whether the mission was played: whether it met what its scenario expects is not asked here.
bool played(int exit_code) { return exit_code == kExitOk || exit_code == kExitNegative; }

}  // namespace

Verdict judged_over_dds(const Case& one, const JudgeOptions& options) {
  const Folder folder(options.log, fs::path(one.name).stem().string());
  run_tool::RunOptions run;
  run.scenario = file_of(one, folder.path());
  run.out = folder.path().string();
  run.quiet = true;
  run.overrides.rate = options.over_dds_at;
  std::ostringstream said;
  const int code = run_tool::run(run, said, said);
  const auto recorded = read_recorded(run.out);
  if (!recorded) {
    Verdict verdict;
    verdict.violations.push_back({"crash", 0, "", 0, said.str() + to_text(recorded.error())});
    return verdict;
  }
  Verdict verdict = verdict_on(*recorded, options.only);
  if (!played(code)) verdict.violations.push_back({"crash", verdict.flown, "", 0, said.str()});
  return verdict;
}

}  // namespace skein::storm_tool
