// SPDX-License-Identifier: Apache-2.0
// Discovery of remote writers for readers that are made only when there is one.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/rtps/link.hpp"
#include "adapters/rtps/mailbox.hpp"

namespace skein::blackboard::rtps {

/// The readers that wait for somebody who writes, and whether what is written is what they read.
/// The middleware tells of every writer that it finds, the owner takes what came true; each once.
/// What others call their topics and partitions takes no memory. Thread rule: found() from any
/// thread, the others from the owner's.
class AwaitedWriters {
 public:
  struct Reader {
    std::size_t channel = 0;
    wire::Slot slot{};
    bool operator==(const Reader&) const = default;
  };

  /// The mailbox, which outlives it, is notified of what is found.
  explicit AwaitedWriters(Mailbox& mailbox) : mailbox_(mailbox) {}

  /// The readers of the channel with that index which wait. Before anything is found.
  void await(std::size_t channel, const LinkPlan& link);
  /// Somebody else writes this, of that type, in these partitions (none: the default one). Of
  /// another type than the slot's it is no writer that is awaited: it cannot be read, and where it
  /// could be meant for this node the mailbox gets it as malformed, once for each that is found.
  void found(std::string_view topic, std::string_view type,
             const std::vector<std::string>& partitions);
  /// In the order in which they were found, since the last call.
  std::vector<Reader> take();

 private:
  struct Waiting {
    std::string partition;
    std::size_t channel = 0;
  };

  void refuse(wire::Slot slot, std::string_view type, const std::vector<std::string>& partitions);

  Mailbox& mailbox_;
  std::mutex mutex_;
  std::map<wire::Slot, std::vector<Waiting>> readers_;  ///< waiting or not
  std::map<wire::Slot, std::vector<Waiting>> waiting_;
  std::vector<Reader> found_;
};

}  // namespace skein::blackboard::rtps
