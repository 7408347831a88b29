// SPDX-License-Identifier: Apache-2.0
// Checks that the runner hears every daemon of the run.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/time.hpp"

namespace skein::run_tool {

/// A mission starts once its clock's leader has heard every daemon; whether the runner has too
/// decides nothing there, and DDS may introduce two of three only. So who runs is compared with who
/// was heard: one who is not heard is given kPatience, then it is listened anew, once in a run, and
/// after the same time again it is given up. All times are steady; none decreases.
class RollCall {
 public:
  static constexpr Duration kPatience = Duration::milliseconds(10'000);

  enum class Verdict { kGoOn, kListenAnew, kGiveUp };

  /// The node was (re)started; it has not been heard since.
  void started(const std::string& name, Duration steady) { lives_[name] = Life{steady, false}; }
  /// Nodes that this runner did not start are ignored.
  void heard(const std::string& name);
  /// The node is not expected to be heard any more.
  void killed(const std::string& name) { lives_.erase(name); }
  /// The clock runs, or has run; the first time counts.
  void runs(Duration steady);
  void listens_anew(Duration steady) { anew_ = steady; }

  Verdict verdict(Duration steady) const;
  /// Nodes that were not heard, whether or not their time is over; ordered by name.
  std::vector<std::string> unheard() const;
  /// Who was not heard though it has had the time, or takes part since the start. By name; nobody
  /// as long as the clock does not run.
  std::vector<std::string> missing(Duration steady) const;

 private:
  struct Life {
    Duration since;
    bool heard = false;
  };
  /// Of who is not heard, how long it could have been.
  Duration longest_silence(Duration steady) const;

  std::map<std::string, Life> lives_;
  std::optional<Duration> runs_since_;
  std::optional<Duration> anew_;
};

}  // namespace skein::run_tool
