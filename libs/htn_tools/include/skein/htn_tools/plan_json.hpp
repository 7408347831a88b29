// SPDX-License-Identifier: Apache-2.0
// Plans and outcomes as JSON, for programs. `read_plans` (given_plan.hpp) reads it back.
#pragma once

#include <optional>
#include <string>

#include "skein/htn/planner.hpp"

namespace skein::htn {

struct PlanJsonOptions {
  bool internal = true;  ///< write steps `!!name`; without them the object says "internal":false
  bool tree = false;     ///< write the decomposition
  bool states = false;  ///< write what each step changes: "changes":[{"deleted":[…],"added":[…]},…]
};

/// A term: symbols as strings, numbers as numbers, proper lists as arrays; a Lisp string as a
/// string in quotes of its own ("\"text\""), a ratio as "1/3", a dotted list as ["a",".","b"], an
/// unbound variable as "?_7". Floats have the fewest digits that read back as the same number of
/// their precision. Cost: linear; no recursion.
void append_json(Term term, const TermStore& store, std::string& out);

/// {"cost":…,"steps":[["!takeoff","karma"],…],"costs":[…]} and, if asked for, "tree": an array of
/// nodes, the root first:
/// {"kind":"task"|"ordered"|"unordered"|"step","task":[…],"method":label,"immediate":true,
///  "children":[position,…],"step":position,"support":[{"fact":[…],"step":position|"initial"|"outside"}]}
/// with absent parts left out. Positions count from 0. Without internal steps their nodes stay in
/// the tree, without "step", and what they made is from "internal".
void append_json(const Plan& plan, const TermStore& store, const PlanJsonOptions& options,
                 std::string& out);

/// What is reported of one problem besides the planner's outcome.
struct PlanningReport {
  std::string problem;
  std::string domain;
  double seconds = 0;          ///< processor time of the planning
  double reading_seconds = 0;  ///< of reading and compiling everything
  double memory_mb = 0;        ///< greatest resident memory of the process so far
};

/// One line (without its end), spec 3.2: {"problem":…,"domain":…,"result":"plan"|"no-plan"|"limit"|
/// "error","why":…,"plans":[…],"expansions":…,"inferences":…,"deepest":…,"seconds":…,
/// "reading_seconds":…,"memory_mb":…,"standing":{…},"repeats_left_out":…,"failure":{…}}. `why`,
/// `failure` and `standing` are left out when there are none, `repeats_left_out` unless several
/// plans were found.
std::string to_json(const PlanningReport& report, const Outcome& outcome, const TermStore& store,
                    const PlanJsonOptions& options);

}  // namespace skein::htn
