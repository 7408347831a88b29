// SPDX-License-Identifier: Apache-2.0
// Whether one member can do several tasks one after the other.
#pragma once

#include <cstdint>
#include <vector>

#include "chains.hpp"

namespace skein::auction {

/// Tasks of one member, in the dates that windows and precedences leave to each. Ways between
/// places take no time.
class OneMember {
 public:
  /// So many tasks are judged by all their orders; of more only what interval is too full is found.
  static constexpr std::size_t kByAllOrders = 14;

  /// Both outlive it; `chains` holds.
  OneMember(const Catalogue& catalogue, const Chains& chains)
      : catalogue_(catalogue), chains_(chains) {}

  /// Of these tasks some that fit in no order, though they do without any one of them, if they are
  /// not too many; empty: none were found. Cost: 2^kByAllOrders at the most for each task.
  std::vector<std::uint32_t> misfits(const std::vector<std::uint32_t>& tasks) const;

  double begin(std::uint32_t task) const {
    return chains_.earliest_end(task) - catalogue_.task(task).duration;
  }

 private:
  using Tasks = std::vector<std::uint32_t>;
  bool fit(const Tasks& tasks) const;
  std::vector<std::uint32_t> befores(const Tasks& tasks) const;
  bool comes_before(std::uint32_t first, std::uint32_t then) const;
  Tasks overfull(const Tasks& tasks) const;

  const Catalogue& catalogue_;
  const Chains& chains_;
};

}  // namespace skein::auction
