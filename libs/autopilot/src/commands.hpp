// SPDX-License-Identifier: Apache-2.0
// Commands to the autopilot until they are answered.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "outbox.hpp"

namespace skein::autopilot {

using Command = std::variant<mavlink::CommandLong, mavlink::CommandInt>;
/// "NAV_TAKEOFF", "command 42".
std::string name_of_command(std::uint16_t command);

/// An acknowledgement has no number, so at most one command of a kind is under way to a component;
/// others of the kind wait for its answer. A place to fly to or a mode that waits replaces the one
/// before it, which is then not sent again.
///
/// | when | then |
/// | no answer for half a second | sent again, five times in all |
/// | "in progress" | waited for, ten seconds |
/// | "temporarily rejected" | sent again after a second, within the five times |
/// | another answer, or none | the outcome |
class Commands {
 public:
  using Ticket = std::uint64_t;
  struct Outcome {
    Ticket ticket = 0;
    bool accepted = false;
    std::string why = {};  ///< of one that was not accepted
  };

  explicit Commands(mavlink::Address own) : own_(own) {}

  Ticket ask(Command command, Duration now, Outbox& out);
  /// What an answer decides, and what follows it is sent.
  std::vector<Outcome> hear(const mavlink::CommandAck& ack, mavlink::Address from, Duration now,
                            Outbox& out);
  /// What got no answer.
  std::vector<Outcome> step(Duration now, Outbox& out);
  /// Nothing is sent again, and answers that still come mean nothing; but for what asks for
  /// messages, which moves nothing.
  void drop();

 private:
  struct Asked {
    Ticket ticket;
    Command command;
    int sent = 0;
    Duration again_at{};
  };
  using Queue = std::deque<Asked>;
  using Key = std::pair<std::uint8_t, std::uint16_t>;  ///< component, command

  static void send(Asked& asked, Duration now, Outbox& out);
  static void advance(Queue& queue, Duration now, Outbox& out);

  mavlink::Address own_;
  Ticket next_ = 1;
  std::map<Key, Queue> waiting_;
};

}  // namespace skein::autopilot
