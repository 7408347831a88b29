// SPDX-License-Identifier: Apache-2.0
// What readers of Cyclone DDS do with what comes.
#pragma once

#include <dds/dds.h>

#include <cstddef>

#include "adapters/rtps/mailbox.hpp"
#include "skein/blackboard/wire.hpp"

namespace skein::blackboard::cyclonedds {

/// Takes what a reader has, at once, in the middleware's thread; one for each reader.
class ReaderListener {
 public:
  /// The mailbox outlives it.
  ReaderListener(rtps::Mailbox& mailbox, std::size_t channel, wire::Slot slot)
      : mailbox_(mailbox), channel_(channel), slot_(slot) {}

  /// Negative: the reader could not be made.
  dds_entity_t make_reader(dds_entity_t subscriber, dds_entity_t topic, const dds_qos_t& qos);

 private:
  void take_all(dds_entity_t reader);

  rtps::Mailbox& mailbox_;
  std::size_t channel_;
  wire::Slot slot_;
};

}  // namespace skein::blackboard::cyclonedds
