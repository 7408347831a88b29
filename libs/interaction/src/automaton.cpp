// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/automaton.hpp"

namespace skein::interaction {

std::optional<ComponelIndex> Automaton::add(Componel componel) {
  const ComponelIndex index = componels_.size();
  if (!indices_.emplace(componel.id, index).second) return std::nullopt;
  if (index > 0) componels_[componel.parent].block()->content.push_back(index);
  componels_.push_back(std::move(componel));
  return index;
}

std::optional<ComponelIndex> Automaton::find(std::string_view id) const {
  const auto found = indices_.find(std::string(id));
  if (found == indices_.end()) return std::nullopt;
  return found->second;
}

std::vector<std::string> Automaton::ids() const {
  std::vector<std::string> all;
  all.reserve(componels_.size());
  for (const Componel& one : componels_) all.push_back(one.id);
  return all;
}

ComponelIndex Automaton::end_of(ComponelIndex index) const {
  const Block* block = componels_[index].block();
  while (block != nullptr && !block->content.empty()) {
    index = block->content.back();
    block = componels_[index].block();
  }
  return index + 1;
}

}  // namespace skein::interaction
