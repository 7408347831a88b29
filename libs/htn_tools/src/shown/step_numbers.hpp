// SPDX-License-Identifier: Apache-2.0
// Which steps of a plan are shown, and under which number.
#pragma once

#include <vector>

#include "skein/htn/plan.hpp"

namespace skein::htn {

/// Shown steps are numbered from 0 in the order of execution.
class StepNumbers {
 public:
  StepNumbers(const Plan& plan, bool internal) : numbers_(plan.steps.size(), kNoStep) {
    for (StepIndex at = 0; at < plan.steps.size(); ++at) {
      if (internal || !plan.steps[at].internal) numbers_[at] = count_++;
    }
  }
  StepIndex count() const { return count_; }
  /// kNoStep for a step that is left out.
  StepIndex operator[](StepIndex step) const {
    return step < numbers_.size() ? numbers_[step] : kNoStep;
  }

 private:
  std::vector<StepIndex> numbers_;
  StepIndex count_ = 0;
};

}  // namespace skein::htn
