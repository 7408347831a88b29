// SPDX-License-Identifier: Apache-2.0
#include "proof/budget.hpp"

#include <algorithm>

namespace skein::htn {

void Budget::note_memory() {
  greatest_memory_ = std::max<std::uint64_t>(greatest_memory_, memory_());
}

bool Budget::check() {
  next_check_ = inferences_ + kInferencesPerCheck;
  if (limits_.inferences) {
    if (inferences_ > *limits_.inferences) return stop("inferences");
    next_check_ = std::min(next_check_, *limits_.inferences + 1);
  }
  if (stopped()) return false;
  if (host_.cancelled && host_.cancelled()) return stop("cancelled");
  if (limits_.seconds && host_.cpu_seconds && host_.cpu_seconds() - start_ > *limits_.seconds) {
    return stop("time");
  }
  note_memory();
  if (limits_.memory_bytes && greatest_memory_ > *limits_.memory_bytes) return stop("memory");
  return true;
}

}  // namespace skein::htn
