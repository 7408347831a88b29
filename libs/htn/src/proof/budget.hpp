// SPDX-License-Identifier: Apache-2.0
// Budget of a search: work done, and limits.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "skein/htn/planner.hpp"

namespace skein::htn {

/// Counts the work of a search against its limits. Each call costs a comparison; the host's stop
/// function is polled every few thousand inferences.
class Budget {
 public:
  Budget(const Limits& limits, const Host& host, std::function<std::size_t()> memory)
      : limits_(limits), host_(host), memory_(std::move(memory)) {
    if (host_.cpu_seconds) start_ = host_.cpu_seconds();
  }

  /// Counts one goal tried; false if the search must stop.
  bool infer() { return ++inferences_ < next_check_ || check(); }
  /// Counts one expanded task; false if the search must stop.
  bool expand() {
    ++expansions_;
    if (limits_.expansions && expansions_ > *limits_.expansions) return stop("expansions");
    return expansions_ % kExpansionsPerCheck != 0 || check();
  }
  /// Subtracts inferences that do not belong to the search.
  void take_back(std::uint64_t inferences) { inferences_ -= inferences; }
  void fail(std::string error) {
    if (why_.empty()) {
      why_ = std::move(error);
      error_ = true;
    }
  }
  bool stop(std::string limit) {
    if (why_.empty()) why_ = std::move(limit);
    return false;
  }
  bool stopped() const { return !why_.empty(); }
  bool error() const { return error_; }
  const std::string& why() const { return why_; }
  std::uint64_t inferences() const { return inferences_; }
  std::uint64_t expansions() const { return expansions_; }
  std::uint64_t greatest_memory() {
    note_memory();
    return greatest_memory_;
  }

 private:
  bool check();
  void note_memory();

  static constexpr std::uint64_t kInferencesPerCheck = 2048;
  static constexpr std::uint64_t kExpansionsPerCheck = 256;  // where conditions are empty
  const Limits& limits_;
  const Host& host_;
  std::function<std::size_t()> memory_;
  double start_ = 0;
  std::uint64_t inferences_ = 0;
  std::uint64_t next_check_ = 1;
  std::uint64_t expansions_ = 0;
  std::uint64_t greatest_memory_ = 0;
  std::string why_;
  bool error_ = false;
};

}  // namespace skein::htn
