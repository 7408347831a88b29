// SPDX-License-Identifier: Apache-2.0
// Plays scenarios, each in a process of its own, and judges them by the laws.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "skein/laws/violation.hpp"

namespace skein::storm_tool {

/// A scenario to be judged.
struct Case {
  std::string name;  ///< for people
  std::string yaml;  ///< its text
  std::string file;  ///< where it stands, or would: its models are relative to that
};

/// The result of a case.
struct Verdict {
  bool valid = true;  ///< the scenario could be read; else `problem` says why not
  std::string problem;
  std::vector<laws::Violation> violations;  ///< "crash" and "hang" among them
  int goals = 0, achieved = 0, failed = 0;
  double flown = 0;     ///< [s] of mission time
  double nearest = -1;  ///< least distance of two UAVs in the air [m]; negative: never two
};

struct JudgeOptions {
  std::vector<std::string> only = {};  ///< laws; all if empty
  bool twice = false;                  ///< plays each twice: the law "same-bytes"
  int jobs = 1;
  int patience = 60;     ///< [s] of processor time for one
  std::string log = {};  ///< folder in which each event log is kept as NAME.jsonl; none if empty
  /// By daemons over DDS at that many mission seconds per second, as `skein run` does, instead of
  /// in virtual time; `log` keeps the whole folder of each run.
  std::optional<double> over_dds_at = {};
};

/// All laws that a mission is judged by, a line each: "NAME: what it says", names with commas.
void print_laws(std::ostream& out);
/// The error of unknown names of laws, with the nearest names; empty: none.
std::string problem_of_laws(const std::vector<std::string>& names);

/// The laws of truth (laws/laws.hpp), and "protocol" (laws/protocol.hpp), "crash", "hang" and
/// "same-bytes". A verdict by `tell` for each case, in the order in which they are done. A process
/// that dies or takes too long breaks the law "crash" or "hang". `next` gives the next case, false
/// when there is none.
void judge(const std::function<bool(Case&)>& next, const JudgeOptions& options,
           const std::function<void(const Case&, const Verdict&)>& tell);
Verdict judge_one(const Case& one, const JudgeOptions& options);

}  // namespace skein::storm_tool
