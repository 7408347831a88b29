// SPDX-License-Identifier: Apache-2.0
// Idempotence of commands: each is executed once.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "bus.hpp"

namespace skein::decision_node {

/// Keeps the last answers. Commands arrive in the order of the ground station's lives and of their
/// numbers, so a command older than every kept answer was answered long ago, and the answer was
/// received: it is ignored.
class Commands {
 public:
  static constexpr std::size_t kKept = 256;

  explicit Commands(Bus& bus) : bus_(bus) {}

  /// Whether the command is to be executed. A command that was answered before is not; its answer
  /// is sent again if it is still kept.
  bool is_new(const CommandKey& key) {
    const auto known = answered_.find(key);
    if (known != answered_.end()) bus_.emit(known->second);
    return known == answered_.end() && (!dropped_ || *dropped_ < key);
  }
  void answer(const Command& command, bool accepted, const std::string& why) {
    answer({command.key, kind_of(command.request), id_of(command.request), accepted, why});
  }
  void refuse(const Command& command, const std::string& why) { answer(command, false, why); }
  void refuse(const UnreadableCommand& command) {
    answer({command.key, command.kind, command.id, false, command.why});
  }

 private:
  void answer(const Answer& answer) {
    answered_.emplace(answer.key, answer);
    if (answered_.size() > kKept) dropped_ = answered_.extract(answered_.begin()).key();
    bus_.emit(answer);
  }

  Bus& bus_;
  std::map<CommandKey, Answer> answered_;
  std::optional<CommandKey> dropped_;  ///< the newest command whose answer is no longer kept
};

}  // namespace skein::decision_node
