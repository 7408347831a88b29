// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/automaton.hpp"

#include <algorithm>
#include <cmath>

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

namespace {

void fill_in(Formula& formula, const std::map<std::string, double>& seconds) {
  for (Clause& clause : formula) {
    for (Literal& literal : clause) {
      auto* time = std::get_if<TimeIs>(&literal.condition);
      const auto known = time == nullptr ? seconds.end() : seconds.find(time->named);
      if (known == seconds.end()) continue;
      const double known_seconds = std::isnan(known->second) ? 0 : known->second;
      time->after = Duration::seconds(std::clamp(known_seconds, -kLatestTime, kLatestTime));
      time->named.clear();
    }
  }
}

void collect_named(const Formula& formula, std::set<std::string>& names) {
  for (const Clause& clause : formula) {
    for (const Literal& literal : clause) {
      const auto* time = std::get_if<TimeIs>(&literal.condition);
      if (time != nullptr && !time->named.empty()) names.insert(time->named);
    }
  }
}

}  // namespace

std::set<std::string> named_times(const Automaton& automaton) {
  std::set<std::string> names;
  for (const Componel& one : automaton.componels()) {
    if (one.block() == nullptr) continue;
    collect_named(one.block()->precondition, names);
    collect_named(one.block()->exit, names);
  }
  return names;
}

Automaton with_times(Automaton automaton, const std::map<std::string, double>& seconds) {
  for (ComponelIndex i = 0; i < automaton.size(); ++i) {
    Block* block = automaton[i].block();
    if (block == nullptr) continue;
    fill_in(block->precondition, seconds);
    fill_in(block->exit, seconds);
  }
  return automaton;
}

}  // namespace skein::interaction
