// SPDX-License-Identifier: Apache-2.0
// Boards that hear each other in memory, in virtual time.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/memory_transport.hpp"

namespace skein::blackboard::testing {

/// What the boards hand over goes to `see`, in the order of the nodes' numbers. A second process
/// with the number of a node is started and addressed under another number (`process`).
class MemoryBoards {
 public:
  explicit MemoryBoards(std::function<void(NodeNumber, Incoming&&)> see) : see_(std::move(see)) {}

  /// Anew, if it is there already.
  void start(const Config& config) { start(config.self, config); }
  void start(NodeNumber process, const Config& config) {
    End& end = ends_[process];
    end.board.reset();
    end.transport = std::make_unique<MemoryTransport>(hub_);
    end.board = std::make_unique<Blackboard>(std::move(*Blackboard::open(config, *end.transport)));
  }
  void kill(NodeNumber process) { ends_.erase(process); }
  bool runs(NodeNumber process) const { return ends_.contains(process); }
  Blackboard& operator[](NodeNumber process) { return *ends_.at(process).board; }
  MemoryHub& hub() { return hub_; }

  /// Of the channels between two nodes, in both directions, at everybody.
  void set_condition(NodeNumber one, NodeNumber other, const ChannelCondition& condition) {
    for (auto& [number, end] : ends_) {
      end.board->set_condition(one, other, condition, now());
      end.board->set_condition(other, one, condition, now());
    }
  }

  /// Until nobody has anything more to say at this instant.
  void settle() {
    for (bool busy = true; busy;) {
      busy = false;
      for (const auto& [number, end] : ends_) {
        for (Incoming& incoming : end.board->step(now())) {
          busy = true;
          see_(number, std::move(incoming));
        }
      }
    }
  }
  void run_until(Duration until) {
    while (now_ < until) {
      Duration next = until;
      for (const auto& [number, end] : ends_)
        if (const auto due = end.board->next_wakeup()) next = std::min(next, *due);
      now_ = std::max(now_, next);
      settle();
    }
  }
  Duration time() const { return now_; }
  Now now() const { return {MissionTime() + now_, now_}; }

 private:
  struct End {
    std::unique_ptr<MemoryTransport> transport;
    std::unique_ptr<Blackboard> board;
  };

  std::function<void(NodeNumber, Incoming&&)> see_;
  MemoryHub hub_;
  Duration now_;
  std::map<NodeNumber, End> ends_;
};

}  // namespace skein::blackboard::testing
