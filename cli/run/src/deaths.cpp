// SPDX-License-Identifier: Apache-2.0
#include "deaths.hpp"

#include <algorithm>
#include <utility>

namespace skein::run_tool {

Deaths::Deaths(std::vector<scenario::KillSpec> kills, double rate)
    : kills_(std::move(kills)), rate_(rate) {
  std::stable_sort(kills_.begin(), kills_.end(),
                   [](const auto& a, const auto& b) { return a.at < b.at; });
}

std::optional<Deaths::Deed> Deaths::next(MissionTime mission, Duration steady,
                                         const std::function<Stage(const std::string&)>& stage_of) {
  while (!kills_.empty() && kills_.front().at <= mission) {
    const scenario::KillSpec kill = kills_.front();
    kills_.erase(kills_.begin());
    if (kill.restart_after) {
      const Duration away = Duration::seconds(kill.restart_after->to_seconds() / rate_);
      restarts_.push_back({steady + away, kill.node, kill.forgets});
    }
    if (stage_of(kill.node) == Stage::kLives) return Deed{kill.node, true, false};
  }
  for (auto one = restarts_.begin(); one != restarts_.end();) {
    if (one->at > steady || stage_of(one->node) == Stage::kDies) {
      ++one;
      continue;
    }
    const Restart restart = *one;
    one = restarts_.erase(one);
    if (stage_of(restart.node) == Stage::kDead) return Deed{restart.node, false, restart.forgets};
  }
  return std::nullopt;
}

}  // namespace skein::run_tool
