// SPDX-License-Identifier: Apache-2.0
// Commands are executed once.
#pragma once

#include <map>
#include <string>

#include "bus.hpp"

namespace skein::decision_node {

class Commands {
 public:
  explicit Commands(Bus& bus) : bus_(bus) {}

  /// False: it has been answered, and the answer goes out again.
  bool is_new(const CommandKey& key) {
    const auto known = answered_.find(key);
    if (known != answered_.end()) bus_.emit(known->second);
    return known == answered_.end();
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
    bus_.emit(answer);
  }

  Bus& bus_;
  std::map<CommandKey, Answer> answered_;
};

}  // namespace skein::decision_node
