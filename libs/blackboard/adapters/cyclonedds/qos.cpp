// SPDX-License-Identifier: Apache-2.0
// The delivery classes as QoS of Cyclone DDS.
#include "qos.hpp"

#include "adapters/rtps/kept_samples.hpp"
#include "skein/blackboard/transport.hpp"

namespace skein::blackboard::cyclonedds {
namespace {

int depth(wire::Slot slot, ChannelKind kind) {
  if (wire::slot_class(slot) != wire::SlotClass::kEvent) return 1;
  return static_cast<int>(kind == ChannelKind::kWorld ? kWorldEventDepth : kEventDepth);
}

/// What writer and reader must agree on, and that no limit refuses a new instance.
Qos class_qos(wire::Slot slot, ChannelKind kind) {
  Qos qos(dds_create_qos());
  const bool stream = wire::slot_class(slot) == wire::SlotClass::kStream;
  dds_qset_reliability(qos.get(), stream ? DDS_RELIABILITY_BEST_EFFORT : DDS_RELIABILITY_RELIABLE,
                       DDS_MSECS(100));
  dds_qset_durability(qos.get(), stream ? DDS_DURABILITY_VOLATILE : DDS_DURABILITY_TRANSIENT_LOCAL);
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, depth(slot, kind));
  dds_qset_resource_limits(qos.get(), DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED,
                           DDS_LENGTH_UNLIMITED);
  // Where a partition is shared, our readers would also match our own writers.
  dds_qset_ignorelocal(qos.get(), DDS_IGNORELOCAL_PARTICIPANT);
  return qos;
}

}  // namespace

Qos partition_qos(const std::string& partition) {
  Qos qos(dds_create_qos());
  const char* const name = partition.c_str();
  dds_qset_partition(qos.get(), 1, const_cast<const char**>(&name));
  return qos;
}

Qos writer_qos(wire::Slot slot, ChannelKind kind) {
  Qos qos = class_qos(slot, kind);
  // For whom comes late Cyclone keeps what the durability service would.
  dds_qset_durability_service(qos.get(), 0, DDS_HISTORY_KEEP_LAST, depth(slot, kind),
                              DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
  // A writer that a cut deletes has not withdrawn what it said.
  dds_qset_writer_data_lifecycle(qos.get(), false);
  if (wire::slot_class(slot) == wire::SlotClass::kEvent && kind != ChannelKind::kWorld) {
    dds_qset_lifespan(qos.get(), DDS_SECS(rtps::kEventLifespan.count()));
  }
  return qos;
}

Qos reader_qos(wire::Slot slot, ChannelKind kind) { return class_qos(slot, kind); }

}  // namespace skein::blackboard::cyclonedds
