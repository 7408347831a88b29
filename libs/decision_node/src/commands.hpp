// SPDX-License-Identifier: Apache-2.0
// Commands are executed once.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "bus.hpp"

namespace skein::decision_node {

/// The last answers are kept. Commands come in the order of their numbers and in that of the ground
/// station's lives, so one that is older than all of these was answered long ago, and its answer
/// has come: it is passed over.
class Commands {
 public:
  static constexpr std::size_t kKept = 256;

  explicit Commands(Bus& bus) : bus_(bus) {}

  /// False: it has been answered, and the answer, if it is kept, goes out again.
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
  std::optional<CommandKey> dropped_;  ///< the latest answer that is kept no more
};

}  // namespace skein::decision_node
