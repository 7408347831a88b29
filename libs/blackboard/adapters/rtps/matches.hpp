// SPDX-License-Identifier: Apache-2.0
// Which writers have found a reader.
#pragma once

#include <cstddef>
#include <vector>

#include "adapters/rtps/mailbox.hpp"

namespace skein::blackboard::rtps {

/// Between the threads of a middleware and that of the links. Thread rule: found() from any thread,
/// take() from the owner's.
class Matches {
 public:
  struct Writer {
    std::size_t channel = 0;
    wire::Slot slot{};
  };

  /// The mailbox, which outlives it, is notified of what is found.
  explicit Matches(Mailbox& mailbox) : mailbox_(mailbox) {}

  void found(Writer writer) {
    found_.put(writer);
    mailbox_.notify();
  }
  /// In the order in which they were found, since the last call.
  std::vector<Writer> take() { return found_.take(); }

 private:
  Mailbox& mailbox_;
  MailboxOf<Writer> found_;
};

}  // namespace skein::blackboard::rtps
