// SPDX-License-Identifier: Apache-2.0
#include "progress.hpp"

#include <ostream>

namespace skein::plan_tool {

namespace {

constexpr const char* kClearLine = "\r\033[K";

}  // namespace

void Progress::begin(const std::string& problem) {
  problem_ = problem;
  plans_ = 0;
  best_.reset();
  if (!shown_) return;
  began_ = cpu_seconds_();
  next_ = began_ + 1;
}

void Progress::see(const htn::Plan& plan) {
  ++plans_;
  if (!best_ || htn::less_value(plan.cost, *best_)) best_ = plan.cost;
}

void Progress::tick() {
  if (!shown_) return;
  const double now = cpu_seconds_();
  if (now < next_) return;
  next_ = now + 1;
  visible_ = true;
  err_ << kClearLine << problem_ << ": " << static_cast<int>(now - began_) << " s, ";
  if (best_) {
    err_ << plans_ << (plans_ == 1 ? " plan" : " plans") << ", best cost " << htn::to_text(*best_);
  } else {
    err_ << "no plan yet";
  }
  err_ << "; Ctrl-C ends with the best so far" << std::flush;
}

void Progress::end() {
  if (visible_) err_ << kClearLine << std::flush;
  visible_ = false;
}

}  // namespace skein::plan_tool
