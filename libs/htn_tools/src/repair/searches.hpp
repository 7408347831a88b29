// SPDX-License-Identifier: Apache-2.0
// Searches the ways of repairing a plan, the small ones first, and takes the best plan.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "repair/old_tree.hpp"
#include "skein/htn/planner.hpp"
#include "skein/htn_tools/repair.hpp"

namespace skein::htn {

/// One way: the tasks that are begun again.
struct RepairAttempt {
  const OldTree* tree = nullptr;
  std::vector<TreeIndex> again;
  bool free_variables = false;  ///< the problem's tasks as the problem gives them
};

/// Every attempt first gets little effort, then more and more, until each has ended, so that a
/// small repair that searches for ever does not keep a larger one from being found.
class RepairSearches {
 public:
  /// `present` is the whole problem with all that has happened.
  RepairSearches(const Domain& domain, const Problem& present, const RepairRequest& request,
                 const RepairOptions& options, const Host& host);
  /// `applies`: the remaining steps can be done in their order, and their links hold.
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
