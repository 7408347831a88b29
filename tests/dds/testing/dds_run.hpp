// SPDX-License-Identifier: Apache-2.0
// `skein run` as a user starts it, with what it leaves behind.
#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "process.hpp"
#include "skein/journal/record.hpp"

namespace skein::testing {

namespace fs = std::filesystem;

inline const std::string kPrograms = SKEIN_BINARY_DIR "/bin";

/// True as soon as the condition holds, looked at again and again for so many seconds at most.
bool holds_within(double seconds, const std::function<bool()>& condition);

struct Answered {
  int code = -1;
  std::string text;
};

/// One `skein run` over DDS of a copy of a COMETS scenario in a folder of the test's own. The path
/// of that copy is on the command line of each of its daemons, which is how they are found.
class DdsRun {
 public:
  DdsRun();
  DdsRun(const DdsRun&) = delete;
  DdsRun& operator=(const DdsRun&) = delete;
  ~DdsRun();

  /// Before start(): the scenario is scenarios/comets/NAME.yaml followed by `more`.
  void take_scenario(const std::string& name, const std::string& more = "");
  /// scenarios/NAME.yaml, of a folder beside those of the models and domains: "karma/detection".
  void take_scenario_of(const std::string& name, const std::string& more = "");
  /// Replaces text of the scenario.
  void change(const std::string& from, const std::string& to);
  void start(const std::vector<std::string>& options = {});
  /// Before start(), once: a folder for --daemons in which these programs ("skein-ddn") are this
  /// shell script; it finds the true programs in $programs.
  std::string programs_with(const std::set<std::string>& scripted, const std::string& script) const;

  /// Its end; fails the test if it has not come after `seconds`.
  std::optional<run_tool::Process::Status> wait(double seconds = 150);
  /// Until the condition holds; fails the test if it does not within `seconds`, or the run ends.
  void wait_until(const std::string& what, const std::function<bool()>& condition,
                  double seconds = 60);
  /// Until `text` is in what the run has printed.
  void wait_for_output(const std::string& text, double seconds = 60);
  /// `skein WORDS --domain …` for this run's domain, to its end. Once the mission has started.
  Answered skein(std::vector<std::string> words);
  void send(int signal) { process_->send(signal); }

  /// Its daemons that live: "sim", "ground", or the UAV.
  std::set<std::string> daemons() const { return names_of(pids()); }
  void kill_daemon(const std::string& name);
  /// True once no process of this run is left; waits a while for them to be gone.
  bool nothing_runs();
  /// Files in /dev/shm that were not there before the run, look like DDS's and are no living
  /// process's: other programs run at the same time. Precondition: nothing of this run lives.
  std::vector<std::string> left_in_shared_memory() const;

  /// All that it printed, standard output and error.
  std::string output() const;
  fs::path folder() const { return folder_ / "out"; }
  fs::path file(const std::string& name) const { return folder_ / name; }
  std::vector<journal::Record> records() const;
  std::size_t count(const std::string& kind, const std::string& key,
                    const std::string& value) const;

 private:
  struct Daemon {
    pid_t pid = -1;
    std::string name;
  };
  void expect_no_stall() const;
  /// In failed-runs beside the folder of the programs.
  void keep_for_inquiry() const;
  std::vector<Daemon> pids() const;
  static std::set<std::string> names_of(const std::vector<Daemon>& daemons);

  fs::path folder_;
  std::set<std::string> shared_memory_before_;
  std::optional<run_tool::Process> process_;
  int asked_ = 0;
};

/// The scenario (see take_scenario_of) is played to its end, and all of its expectations are met.
void expect_all_met(const std::string& scenario, const std::string& rate);

}  // namespace skein::testing
