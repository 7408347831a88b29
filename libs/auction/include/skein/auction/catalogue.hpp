// SPDX-License-Identifier: Apache-2.0
// A lot with its tasks by number and who is before whom.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "skein/auction/task.hpp"

namespace skein::auction {

/// Of a sale, the same for all that take part; made once and shared. Indexes count from 0.
/// Precedences of unknown tasks are left out: contradictions() tells of them.
class Catalogue {
 public:
  explicit Catalogue(Lot lot);
  const Lot& lot() const { return lot_; }
  std::size_t size() const { return lot_.tasks.size(); }
  bool has(TaskNumber number) const { return index_.contains(number); }
  /// The number is one of the lot.
  std::uint32_t index(TaskNumber number) const;
  const Task& task(std::uint32_t index) const { return lot_.tasks[index]; }
  const Task& task(TaskNumber number) const { return lot_.tasks[index(number)]; }
  const std::vector<std::uint32_t>& before(std::uint32_t task) const { return before_[task]; }
  const std::vector<std::uint32_t>& after(std::uint32_t task) const { return after_[task]; }
  /// Whether what one member does may shift the dates of another: joint tasks and precedences.
  /// Tasks that need several abilities may be joint.
  bool coupled() const { return coupled_; }

 private:
  Lot lot_;
  std::unordered_map<TaskNumber, std::uint32_t> index_;
  std::vector<std::vector<std::uint32_t>> before_, after_;
  bool coupled_ = false;
};

}  // namespace skein::auction
