// SPDX-License-Identifier: Apache-2.0
// What readers of Cyclone DDS do with what comes.
#pragma once

#include <dds/dds.h>

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "adapters/rtps/mailbox.hpp"
#include "skein/blackboard/dds_config.hpp"

namespace skein::blackboard::cyclonedds {

/// Takes what a reader has, at once, in the middleware's thread; one for each reader.
class ReaderListener {
 public:
  /// All references outlive it.
  ReaderListener(rtps::Mailbox& mailbox, std::size_t channel, wire::Slot slot,
                 const std::function<void(const RawSample&)>& tap)
      : mailbox_(mailbox), channel_(channel), slot_(slot), tap_(tap) {}

  /// Negative: the reader could not be made.
  dds_entity_t make_reader(dds_entity_t subscriber, dds_entity_t topic, const dds_qos_t& qos);

 private:
  void take_all(dds_entity_t reader);
  void take(dds_entity_t reader, const ddsi_serdata& data, const dds_sample_info_t& info);
  const std::string& partition_of(dds_entity_t reader, dds_instance_handle_t writer);

  rtps::Mailbox& mailbox_;
  std::size_t channel_;
  wire::Slot slot_;
  const std::function<void(const RawSample&)>& tap_;
  std::map<dds_instance_handle_t, std::string> partitions_;  ///< of writers, for the tap
};

}  // namespace skein::blackboard::cyclonedds
