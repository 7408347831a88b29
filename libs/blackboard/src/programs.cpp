// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/programs.hpp"

#include <utility>

namespace skein::blackboard {

void Programs::found(const std::string& guid, std::string name, std::string description,
                     bool proved) {
  const std::lock_guard lock(mutex_);
  const auto [place, is_new] = programs_.try_emplace(guid);
  if (is_new) place->second = {std::move(name), std::move(description), proved, ++discovered_};
}

void Programs::proved(const std::string& guid) {
  const std::lock_guard lock(mutex_);
  const auto found = programs_.find(guid);
  if (found != programs_.end()) found->second.proved = true;
}

void Programs::gone(const std::string& guid) {
  const std::lock_guard lock(mutex_);
  programs_.erase(guid);
}

std::optional<std::string> Programs::description_of(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  const Program* last = nullptr;
  for (const auto& [guid, program] : programs_) {
    if (!program.proved || program.name != name) continue;
    if (last == nullptr || program.number > last->number) last = &program;
  }
  if (last == nullptr) return std::nullopt;
  return last->description;
}

}  // namespace skein::blackboard
