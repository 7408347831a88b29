// SPDX-License-Identifier: Apache-2.0
#include "one_member.hpp"

#include <algorithm>
#include <limits>

namespace skein::auction {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace

// Through any tasks between.
bool OneMember::comes_before(std::uint32_t first, std::uint32_t then) const {
  std::vector<std::uint32_t> open{first};
  std::vector<bool> seen(catalogue_.size());
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    open.pop_back();
    for (const std::uint32_t next : catalogue_.after(at)) {
      if (next == then) return true;
      if (!seen[next]) open.push_back(next);
      seen[next] = true;
    }
  }
  return false;
}

// For each task the set of those that come before it.
std::vector<std::uint32_t> OneMember::befores(const Tasks& tasks) const {
  std::vector<std::uint32_t> sets(tasks.size());
  for (std::size_t then = 0; then < tasks.size(); ++then)
    for (std::size_t first = 0; first < tasks.size(); ++first)
      if (comes_before(tasks[first], tasks[then])) sets[then] |= 1U << first;
  return sets;
}

// Dynamic programming over the sets of tasks that come first: when their last can end. Source:
// Held, Karp 1962.
bool OneMember::fit(const Tasks& tasks) const {
  const std::vector<std::uint32_t> before = befores(tasks);
  const std::uint32_t all = (1U << tasks.size()) - 1;
  std::vector<double> end(all + 1, kNever);
  end[0] = -kNever;
  for (std::uint32_t set = 1; set <= all; ++set) {
    for (std::size_t last = 0; last < tasks.size(); ++last) {
      const std::uint32_t rest = set & ~(1U << last);
      if (rest == set || (before[last] & ~rest) != 0 || end[rest] == kNever) continue;
      const double ends =
          std::max(end[rest], begin(tasks[last])) + catalogue_.task(tasks[last]).duration;
      if (ends <= chains_.latest_end(tasks[last])) end[set] = std::min(end[set], ends);
    }
  }
  return end[all] < kNever;
}

// Those between some beginning and some deadline that last longer than there is time.
OneMember::Tasks OneMember::overfull(const Tasks& tasks) const {
  for (const std::uint32_t first : tasks) {
    for (const std::uint32_t last : tasks) {
      Tasks inside;
      double lasts = 0;
      for (const std::uint32_t task : tasks) {
        if (begin(task) < begin(first) || chains_.latest_end(task) > chains_.latest_end(last))
          continue;
        inside.push_back(task);
        lasts += catalogue_.task(task).duration;
      }
      if (!inside.empty() && begin(first) + lasts > chains_.latest_end(last)) return inside;
    }
  }
  return {};
}

// What fits without a task fits without less: one pass leaves nothing that could be left out.
std::vector<std::uint32_t> OneMember::misfits(const Tasks& tasks) const {
  Tasks found = tasks.size() > kByAllOrders ? overfull(tasks) : tasks;
  if (found.empty() || found.size() > kByAllOrders) return found;
  if (fit(found)) return {};
  for (std::size_t i = found.size(); i-- > 0;) {
    Tasks less = found;
    less.erase(less.begin() + static_cast<std::ptrdiff_t>(i));
    if (!fit(less)) found = std::move(less);
  }
  return found;
}

}  // namespace skein::auction
