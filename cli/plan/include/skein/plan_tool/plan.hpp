// SPDX-License-Identifier: Apache-2.0
// `skein plan`: plans the problems of some files, or checks a plan against them.
#pragma once

#include <array>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "skein/htn/planner.hpp"

namespace skein::plan_tool {

/// Files and values for the host functions of a mission domain (docs/comets-domain.md). Empty:
/// none.
struct MissionFiles {
  std::string world;             ///< --world FILE
  std::string vehicle;           ///< --vehicle FILE: a vehicle model
  std::string uav;               ///< --uav NAME; empty: the model's
  std::array<double, 3> home{};  ///< --home X,Y,Z: `home` and `zero` [m], unless places are
  double altitude = 40;          ///< --altitude H: of flights, over the ground [m]
  bool taskreq = false;          ///< --taskreq: plans in the form of the seeds
};

/// Source: spec 3.2.
struct PlanOptions {
  std::vector<std::string> files;     ///< domains and problems in any order; "-": standard input
  std::vector<std::string> problems;  ///< --problem NAME: only these; empty: all
  htn::Options search;                ///< --which, --optimize-cost, limits
  bool tree = false;                  ///< --tree
  std::string dot;                    ///< --dot FILE; "-": standard output, nothing else there then
  bool json = false;                  ///< --json: one object a line
  bool no_internal = false;     ///< --no-internal: steps `!!name` are left out of what is shown
  bool trace = false;           ///< --trace [TASK…]; the tasks are search.traced_tasks
  bool why_not = false;         ///< --why-not
  bool states = false;          ///< --states: what each step changes
  std::string validate;         ///< --validate PLAN: no planning
  std::string repair;           ///< --repair PLAN: no planning from the start
  htn::StepIndex executed = 0;  ///< --executed N: steps of that plan, internal ones too
  std::vector<std::string> diverge;  ///< --diverge FORM…: what changed by itself
  bool quiet = false;                ///< --quiet: no warnings, no progress
  MissionFiles mission;
};

/// Services of the process that runs the tool; every function may be absent.
struct Surroundings {
  std::function<double()> cpu_seconds;  ///< processor time of the process so far [s]
  std::function<bool()> interrupted;    ///< Ctrl-C came: report what there is and end
  std::function<double()> memory_mb;    ///< greatest resident memory so far [10^6 bytes]
  bool colour_out = false;
  bool colour_err = false;
  bool progress = false;      ///< `err` is a terminal: one line written over each second
  bool process_ends = false;  ///< with the command: what was read is left to the system
};

/// Reports on `out`; on `err` what is wrong or suspicious in the files, and progress. The trace
/// goes to `out`, with --json or --dot - to `err`. Exit codes (docs/exit-codes.md): 0 every problem
/// has a plan, or the plans are valid; 1 some has none, or a plan is not valid; 2 wrong files or
/// names, or a term of the domain that cannot be evaluated; 3 the graph cannot be written; 4 a
/// limit cut some search; 130 interrupted. The first that applies of 130, 2, 3, 4, 1 counts.
int run_plan(const PlanOptions& options, const Surroundings& surroundings, std::istream& in,
             std::ostream& out, std::ostream& err);

}  // namespace skein::plan_tool
