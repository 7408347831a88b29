// SPDX-License-Identifier: Apache-2.0
// The consensus-based bundle algorithm, to compare with: everybody hears everybody, in rounds.
// Source: Choi, Brunet, How 2009, algorithm 3 (bundles) and, as each hears each bid first-hand, the
// rule of the highest bid; what stands in a bundle after a lost task is released with it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "testing/exact_tours.hpp"

namespace skein::auction::testing {

class Cbba {
 public:
  Cbba(std::vector<Place> begins, std::vector<Place> tasks)
      : tasks_(std::move(tasks)),
        agents_(begins.size()),
        winner_(tasks_.size(), kNobody),
        highest_(tasks_.size(), 0) {
    for (std::size_t a = 0; a < begins.size(); ++a) {
      agents_[a].begin = begins[a];
      agents_[a].bids.assign(tasks_.size(), 0);
    }
  }

  // Until no bundle changes. The score of a task is what remains of a reward after the detour, so
  // the sum of scores is largest where the sum of tours is least; bids never rise along a bundle.
  void run() {
    for (rounds_ = 1; rounds_ <= 10 * tasks_.size() + 10; ++rounds_) {
      for (std::size_t a = 0; a < agents_.size(); ++a) build(a);
      messages_ += agents_.size() * (agents_.size() - 1);
      if (!agree()) return;
    }
  }

  double sum() const {
    double all = 0;
    for (const Agent& agent : agents_) all += length(agent, agent.path);
    return all;
  }
  bool complete() const {
    return std::none_of(winner_.begin(), winner_.end(), [](std::size_t a) { return a == kNobody; });
  }
  std::uint64_t messages() const { return messages_; }
  std::size_t rounds() const { return rounds_; }

 private:
  static constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();
  static constexpr double kReward = 1000;
  struct Agent {
    Place begin;
    std::vector<std::size_t> bundle;  ///< in the order of adding
    std::vector<std::size_t> path;    ///< in the order of flying
    std::vector<double> bids;
  };

  double length(const Agent& agent, const std::vector<std::size_t>& path) const {
    double way = 0;
    Place at = agent.begin;
    for (const std::size_t task : path) {
      way += metres(at, tasks_[task]);
      at = tasks_[task];
    }
    return way;
  }

  struct Best {
    double score = 0;
    std::size_t task = kNobody, gap = 0;
  };

  Best best_addition(std::size_t a) const {
    const Agent& agent = agents_[a];
    const double now = length(agent, agent.path);
    const double cap = agent.bundle.empty() ? kReward : agent.bids[agent.bundle.back()];
    Best best;
    for (std::size_t task = 0; task < tasks_.size(); ++task) {
      if (std::find(agent.path.begin(), agent.path.end(), task) != agent.path.end()) continue;
      for (std::size_t gap = 0; gap <= agent.path.size(); ++gap) {
        auto path = agent.path;
        path.insert(path.begin() + static_cast<std::ptrdiff_t>(gap), task);
        const double score = std::min(cap, kReward - (length(agent, path) - now));
        const bool wins = score > highest_[task] || (score == highest_[task] && a < winner_[task]);
        if (wins && score > best.score) best = {score, task, gap};
      }
    }
    return best;
  }

  void build(std::size_t a) {
    for (Best best = best_addition(a); best.task != kNobody; best = best_addition(a)) {
      Agent& agent = agents_[a];
      agent.bundle.push_back(best.task);
      agent.path.insert(agent.path.begin() + static_cast<std::ptrdiff_t>(best.gap), best.task);
      agent.bids[best.task] = best.score;
    }
  }

  // Whether anybody lost something, or somebody is new to a task.
  bool agree() {
    const auto before = winner_;
    winner_.assign(tasks_.size(), kNobody);
    highest_.assign(tasks_.size(), 0);
    for (std::size_t a = 0; a < agents_.size(); ++a) {
      for (const std::size_t task : agents_[a].bundle) {
        if (agents_[a].bids[task] <= highest_[task]) continue;
        highest_[task] = agents_[a].bids[task];
        winner_[task] = a;
      }
    }
    bool changed = before != winner_;
    for (std::size_t a = 0; a < agents_.size(); ++a) changed = release(a) || changed;
    return changed;
  }

  bool release(std::size_t a) {
    Agent& agent = agents_[a];
    const auto lost = std::find_if(agent.bundle.begin(), agent.bundle.end(),
                                   [&](std::size_t task) { return winner_[task] != a; });
    if (lost == agent.bundle.end()) return false;
    for (auto task = lost; task != agent.bundle.end(); ++task) {
      std::erase(agent.path, *task);
      if (winner_[*task] != a) continue;
      winner_[*task] = kNobody;
      highest_[*task] = 0;
    }
    agent.bundle.erase(lost, agent.bundle.end());
    return true;
  }

  std::vector<Place> tasks_;
  std::vector<Agent> agents_;
  std::vector<std::size_t> winner_;
  std::vector<double> highest_;
  std::uint64_t messages_ = 0;
  std::size_t rounds_ = 0;
};

}  // namespace skein::auction::testing
