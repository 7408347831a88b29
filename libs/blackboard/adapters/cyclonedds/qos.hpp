// SPDX-License-Identifier: Apache-2.0
// The delivery classes as QoS of Cyclone DDS.
#pragma once

#include <dds/dds.h>

#include <memory>
#include <string>

#include "skein/blackboard/channel.hpp"

namespace skein::blackboard::cyclonedds {

struct DeleteQos {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};
using Qos = std::unique_ptr<dds_qos_t, DeleteQos>;

/// The QoS of a publisher or subscriber.
Qos partition_qos(const std::string& partition);

/// Source: spec 1.3 (table of classes); the same limits as over Fast DDS.
Qos writer_qos(wire::Slot slot, ChannelKind kind);
Qos reader_qos(wire::Slot slot, ChannelKind kind);

}  // namespace skein::blackboard::cyclonedds
