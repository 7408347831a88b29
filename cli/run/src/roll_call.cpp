// SPDX-License-Identifier: Apache-2.0
#include "roll_call.hpp"

#include <algorithm>

namespace skein::run_tool {

void RollCall::heard(const std::string& name) {
  const auto found = lives_.find(name);
  if (found != lives_.end()) found->second.heard = true;
}

void RollCall::runs(Duration steady) {
  if (!runs_since_) runs_since_ = steady;
}

Duration RollCall::longest_silence(Duration steady) const {
  Duration longest;
  if (!runs_since_) return longest;
  for (const auto& [name, life] : lives_)
    if (!life.heard) longest = std::max(longest, steady - std::max(*runs_since_, life.since));
  return longest;
}

RollCall::Verdict RollCall::verdict(Duration steady) const {
  const Duration silence = longest_silence(steady);
  if (silence < kPatience) return Verdict::kGoOn;
  if (!anew_) return Verdict::kListenAnew;
  const bool had_both = silence >= kPatience + kPatience && steady - *anew_ >= kPatience;
  return had_both ? Verdict::kGiveUp : Verdict::kGoOn;
}

std::vector<std::string> RollCall::unheard() const {
  std::vector<std::string> names;
  for (const auto& [name, life] : lives_)
    if (!life.heard) names.push_back(name);
  return names;
}

std::vector<std::string> RollCall::missing(Duration steady) const {
  std::vector<std::string> names;
  if (!runs_since_) return names;
  for (const auto& [name, life] : lives_) {
    const bool could_be = life.since <= *runs_since_ || steady - life.since >= kPatience;
    if (!life.heard && could_be) names.push_back(name);
  }
  return names;
}

}  // namespace skein::run_tool
