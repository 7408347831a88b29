// SPDX-License-Identifier: Apache-2.0
// Who begins to write what is read only then.
#include "awaited_writers.hpp"

#include <optional>
#include <utility>

#include "skein/blackboard/dds_type.hpp"
#include "skein/blackboard/observer.hpp"

namespace skein::blackboard::rtps {

void AwaitedWriters::await(std::size_t channel, const LinkPlan& link) {
  const std::lock_guard lock(mutex_);
  for (const wire::Slot slot : link.reads) {
    readers_[slot].push_back({link.config.partition, channel});
    if (link.waits_to_read(slot)) waiting_[slot].push_back({link.config.partition, channel});
  }
}

void AwaitedWriters::refuse(wire::Slot slot, std::string_view type,
                            const std::vector<std::string>& partitions) {
  std::optional<std::size_t> channel;
  {
    const std::lock_guard lock(mutex_);
    for (const Waiting& reader : readers_[slot])
      if (!channel && partitions_meet(partitions, {reader.partition})) channel = reader.channel;
  }
  if (!channel) return;
  std::string why = "is " + std::string(type) + ", not " + dds_type_of(slot);
  mailbox_.put({*channel, Malformed{slot, {}, {"type", std::move(why)}}});
  mailbox_.notify();
}

void AwaitedWriters::found(std::string_view topic, std::string_view type,
                           const std::vector<std::string>& partitions) {
  const auto slot = wire::slot_from_name(topic);
  if (!slot) return;
  if (type != dds_type_of(*slot)) return refuse(*slot, type, partitions);
  bool any = false;
  {
    const std::lock_guard lock(mutex_);
    const auto readers = waiting_.find(*slot);
    if (readers == waiting_.end()) return;
    any = std::erase_if(readers->second, [&](const Waiting& reader) {
            const bool meets = partitions_meet(partitions, {reader.partition});
            if (meets) found_.push_back({reader.channel, *slot});
            return meets;
          }) > 0;
  }
  if (any) mailbox_.notify();
}

std::vector<AwaitedWriters::Reader> AwaitedWriters::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(found_, {});
}

}  // namespace skein::blackboard::rtps
