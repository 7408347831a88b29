// SPDX-License-Identifier: Apache-2.0
#include "chains.hpp"

#include <algorithm>

namespace skein::auction {

Chains::Chains(const Catalogue& catalogue)
    : catalogue_(&catalogue),
      end_(catalogue.size()),
      latest_(catalogue.size()),
      cause_(catalogue.size(), -1),
      waiting_(catalogue.size()) {
  forward();
  backward();
}

// Kahn's order, from what waits for nothing on.
void Chains::forward() {
  for (std::uint32_t i = 0; i < catalogue_->size(); ++i) {
    const Task& task = catalogue_->task(i);
    waiting_[i] = catalogue_->before(i).size();
    end_[i] = task.earliest + task.duration;
    latest_[i] = task.deadline;
    if (waiting_[i] == 0) order_.push_back(i);
  }
  for (std::size_t done = 0; done < order_.size(); ++done) {
    const std::uint32_t task = order_[done];
    for (const std::uint32_t after : catalogue_->after(task)) {
      const double begin = end_[task] + catalogue_->delay(task, after).least;
      const double end = begin + catalogue_->task(after).duration;
      if (end > end_[after]) {
        end_[after] = end;
        cause_[after] = static_cast<std::int64_t>(task);
      }
      if (--waiting_[after] == 0) order_.push_back(after);
    }
  }
}

void Chains::backward() {
  for (auto task = order_.rbegin(); task != order_.rend(); ++task) {
    for (const std::uint32_t after : catalogue_->after(*task)) {
      if (stuck(after)) continue;
      const double begin = latest_[after] - catalogue_->task(after).duration;
      latest_[*task] = std::min(latest_[*task], begin - catalogue_->delay(*task, after).least);
    }
  }
}

bool Chains::hold() const {
  for (std::uint32_t i = 0; i < catalogue_->size(); ++i)
    if (stuck(i) || late(i)) return false;
  return true;
}

std::vector<std::uint32_t> Chains::leading_to(std::uint32_t task) const {
  std::vector<std::uint32_t> chain;
  for (std::int64_t at = task; at >= 0; at = cause_[static_cast<std::size_t>(at)])
    chain.push_back(static_cast<std::uint32_t>(at));
  std::reverse(chain.begin(), chain.end());
  return chain;
}

// What is never ready is on a cycle or behind one: going back from it ends on the cycle.
std::vector<std::uint32_t> Chains::circle() const {
  const auto waits =
      std::find_if(waiting_.begin(), waiting_.end(), [](std::size_t n) { return n > 0; });
  if (waits == waiting_.end()) return {};
  auto at = static_cast<std::uint32_t>(waits - waiting_.begin());
  std::vector<std::uint32_t> way;
  while (std::find(way.begin(), way.end(), at) == way.end()) {
    way.push_back(at);
    const auto& before = catalogue_->before(at);
    at = *std::find_if(before.begin(), before.end(), [&](std::uint32_t b) { return stuck(b); });
  }
  std::vector<std::uint32_t> chain{at};
  for (auto back = way.rbegin(); back != way.rend(); ++back) {
    chain.push_back(*back);
    if (*back == at) break;
  }
  return chain;
}

}  // namespace skein::auction
