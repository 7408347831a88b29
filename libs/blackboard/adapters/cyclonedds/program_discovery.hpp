// SPDX-License-Identifier: Apache-2.0
// The programs that take part, as Cyclone DDS finds them.
#pragma once

#include <dds/dds.h>

#include <memory>
#include <utility>

#include "skein/blackboard/programs.hpp"

namespace skein::blackboard::cyclonedds {

/// Reads the built-in topic of participants.
class ProgramDiscovery {
 public:
  /// `programs` may be null: nothing is read.
  explicit ProgramDiscovery(std::shared_ptr<Programs> programs) : programs_(std::move(programs)) {}
  ProgramDiscovery(const ProgramDiscovery&) = delete;
  ProgramDiscovery& operator=(const ProgramDiscovery&) = delete;

  /// From now on until the participant ends, which is before this object does. Negative: the
  /// reason why not.
  dds_return_t begin(dds_entity_t participant);

  /// What the built-in topic has told since; for its listener.
  void take_all(dds_entity_t reader);

 private:
  std::shared_ptr<Programs> programs_;
};

}  // namespace skein::blackboard::cyclonedds
