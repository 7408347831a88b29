// SPDX-License-Identifier: Apache-2.0
// A lot, indexed by task number, with its precedence relation.
#pragma once

#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "skein/auction/task.hpp"

namespace skein::auction {

/// Made once per sale and shared by all participants. Indexes count from 0. Precedences of unknown
/// tasks are left out; contradictions() reports them.
class Catalogue {
 public:
  explicit Catalogue(Lot lot);
  const Lot& lot() const { return lot_; }
  std::size_t size() const { return lot_.tasks.size(); }
  bool has(TaskNumber number) const { return index_.contains(number); }
  /// Precondition: `number` is in the lot.
  std::uint32_t index(TaskNumber number) const;
  const Task& task(std::uint32_t index) const { return lot_.tasks[index]; }
  const Task& task(TaskNumber number) const { return lot_.tasks[index(number)]; }
  const std::vector<std::uint32_t>& before(std::uint32_t task) const { return before_[task]; }
  const std::vector<std::uint32_t>& after(std::uint32_t task) const { return after_[task]; }
  /// Of that precedence; several between the same two are one.
  Delay delay(std::uint32_t first, std::uint32_t then) const;
  /// Whether one member's schedule may shift another's dates: there are precedences or joint tasks.
  /// A task that needs several abilities counts as joint, since it may need several members.
  bool coupled() const { return coupled_; }

 private:
  Lot lot_;
  std::unordered_map<TaskNumber, std::uint32_t> index_;
  std::vector<std::vector<std::uint32_t>> before_, after_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Delay> delays_;  ///< those with bounds
  bool coupled_ = false;
};

}  // namespace skein::auction
