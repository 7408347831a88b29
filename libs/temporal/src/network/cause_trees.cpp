// SPDX-License-Identifier: Apache-2.0
#include "cause_trees.hpp"

namespace skein::temporal {

const std::vector<NodeIndex>& CauseTrees::tree(NodeIndex root, Bound bound) {
  gathered_.assign(1, root);
  for (std::size_t i = 0; i < gathered_.size(); ++i) append_effects(gathered_[i], bound, false);
  return gathered_;
}

void CauseTrees::take_changes(std::vector<BoundChange>& changes) {
  changes.clear();
  for (const Changed& changed : changed_) {
    if (changed.state >= states_.size()) continue;
    states_[changed.state].changed = false;
    const Bound bound = (changed.state & 1) == 0 ? Bound::kLower : Bound::kUpper;
    const Ticks date = to_date(bound, states_[changed.state].value);
    if (date != to_date(bound, changed.old_value)) {
      changes.push_back({changed.state / 2, bound, date});
    }
  }
  changed_.clear();
}

std::size_t CauseTrees::memory_bytes() const {
  const auto bytes = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return bytes(states_) + bytes(changed_) + bytes(gathered_);
}

void CauseTrees::shrink() {
  const auto fit = [](auto&... vectors) { (vectors.shrink_to_fit(), ...); };
  fit(states_, changed_, gathered_);
}

}  // namespace skein::temporal
