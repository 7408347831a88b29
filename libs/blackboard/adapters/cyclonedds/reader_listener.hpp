// SPDX-License-Identifier: Apache-2.0
// What readers of Cyclone DDS do with what comes.
#pragma once

#include <dds/dds.h>

#include <cstddef>

#include "adapters/rtps/mailbox.hpp"
#include "skein/blackboard/wire.hpp"

namespace skein::blackboard::cyclonedds {

/// Takes all samples of a reader as soon as they arrive, in the middleware's thread; one for each
/// reader.
class ReaderListener {
 public:
  /// The mailbox must outlive the listener.
  ReaderListener(rtps::Mailbox& mailbox, std::size_t channel, wire::Slot slot)
      : mailbox_(mailbox), channel_(channel), slot_(slot) {}

  /// Negative: the error code with which the creation of the reader failed.
  dds_entity_t make_reader(dds_entity_t subscriber, dds_entity_t topic, const dds_qos_t& qos);

 private:
  void take_all(dds_entity_t reader);

  rtps::Mailbox& mailbox_;
  std::size_t channel_;
  wire::Slot slot_;
};

}  // namespace skein::blackboard::cyclonedds
