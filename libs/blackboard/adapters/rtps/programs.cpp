// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/programs.hpp"

#include <cstdint>
#include <map>
#include <mutex>
#include <utility>

namespace skein::blackboard {

class Programs::Impl {
 public:
  struct Program {
    std::string name;
    std::string description;
    bool proved = true;
    std::uint64_t number = 0;  ///< of its discovery
  };
  std::mutex mutex;
  std::map<std::string, Program> programs;  ///< by GUID
  std::uint64_t discovered = 0;
};

Programs::Programs() : impl_(std::make_unique<Impl>()) {}
Programs::~Programs() = default;

void Programs::found(const std::string& guid, std::string name, std::string description,
                     bool proved) {
  const std::lock_guard lock(impl_->mutex);
  const auto [place, is_new] = impl_->programs.try_emplace(guid);
  if (is_new)
    place->second = {std::move(name), std::move(description), proved, ++impl_->discovered};
}

void Programs::proved(const std::string& guid) {
  const std::lock_guard lock(impl_->mutex);
  const auto found = impl_->programs.find(guid);
  if (found != impl_->programs.end()) found->second.proved = true;
}

void Programs::gone(const std::string& guid) {
  const std::lock_guard lock(impl_->mutex);
  impl_->programs.erase(guid);
}

std::optional<std::string> Programs::description_of(const std::string& name) const {
  const std::lock_guard lock(impl_->mutex);
  const Impl::Program* last = nullptr;
  for (const auto& [guid, program] : impl_->programs) {
    if (!program.proved || program.name != name) continue;
    if (last == nullptr || program.number > last->number) last = &program;
  }
  if (last == nullptr) return std::nullopt;
  return last->description;
}

}  // namespace skein::blackboard
