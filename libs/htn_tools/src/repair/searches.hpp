// SPDX-License-Identifier: Apache-2.0
// Searches over repair attempts, the smallest repairs first, and chooses the best plan.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "repair/old_tree.hpp"
#include "skein/htn/planner.hpp"
#include "skein/htn_tools/repair.hpp"

namespace skein::htn {

/// One repair attempt, given by the tasks that are begun again.
struct RepairAttempt {
  const OldTree* tree = nullptr;
  std::vector<TreeIndex> again;
  bool free_variables = false;  ///< the problem's tasks as the problem gives them
};

/// Runs all attempts in turn with increasing effort until each has ended, so that an endless search
/// for a small repair does not prevent a larger one from being found.
class RepairSearches {
 public:
  /// `present`: the whole problem, including all events so far.
  RepairSearches(const Domain& domain, const Problem& present, const RepairRequest& request,
                 const RepairOptions& options, const Host& host);
  /// `applies`: the remaining steps are executable in their order, and their causal links hold.
  Repair run(const std::vector<RepairAttempt>& attempts, bool applies);

 private:
  struct Pending {
    const RepairAttempt* attempt;
    RemainingTasks remaining;
    std::vector<Preference> preferences;
  };
  enum class End : std::uint8_t { kDone, kEffort, kStop };

  void prepare(const std::vector<RepairAttempt>& attempts);
  void free_variables(const OldTree& tree, RemainingTasks& remaining) const;
  void number_variables(TaskNetwork& network) const;
  End search(const Pending& pending, std::uint64_t effort);
  Limits limits(std::uint64_t effort) const;
  bool exhausted() const;
  void take(const Pending& pending, Plan made);
  void take_old();
  bool satisfied() const;
  Repair finish();

  const Domain& domain_;
  TermStore& store_;
  const Problem& present_;
  const RepairRequest& request_;
  const RepairOptions& options_;
  const Host& host_;
  double began_ = 0;
  bool applies_ = false;
  std::vector<Pending> pending_;
  std::vector<Repair> found_;
  Statistics statistics_;
  std::size_t attempts_ = 0;
  std::string limit_;
  std::string error_;
};

}  // namespace skein::htn
