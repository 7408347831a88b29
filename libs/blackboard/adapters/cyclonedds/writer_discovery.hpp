// SPDX-License-Identifier: Apache-2.0
// The writers that others have, as Cyclone DDS finds them.
#pragma once

#include <dds/dds.h>

#include "adapters/rtps/awaited_writers.hpp"

namespace skein::blackboard::cyclonedds {

/// Reads the built-in topic of writers.
class WriterDiscovery {
 public:
  /// `awaited` outlives it.
  explicit WriterDiscovery(rtps::AwaitedWriters& awaited) : awaited_(awaited) {}
  WriterDiscovery(const WriterDiscovery&) = delete;
  WriterDiscovery& operator=(const WriterDiscovery&) = delete;

  /// From now on until the participant ends, which is before this object does. Negative: the
  /// reason why not.
  dds_return_t begin(dds_entity_t participant);

  /// What the built-in topic has told since; for its listener.
  void take_all(dds_entity_t reader);

 private:
  rtps::AwaitedWriters& awaited_;
  dds_guid_t own_{};  ///< of the participant
};

}  // namespace skein::blackboard::cyclonedds
