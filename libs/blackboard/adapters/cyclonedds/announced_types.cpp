// SPDX-License-Identifier: Apache-2.0
#include "announced_types.hpp"

#include <string>

#include "qos.hpp"
#include "sample_type.hpp"
#include "skein/blackboard/dds_type.hpp"

namespace skein::blackboard::cyclonedds {

dds_return_t announce_types(dds_entity_t participant, const std::set<wire::Slot>& slots) {
  const dds_entity_t publisher =
      dds_create_publisher(participant, partition_qos(kTypesPartition).get(), nullptr);
  const Qos unmatched(dds_create_qos());
  dds_qset_ownership(unmatched.get(), DDS_OWNERSHIP_EXCLUSIVE);
  dds_qset_reliability(unmatched.get(), DDS_RELIABILITY_BEST_EFFORT, 0);
  for (const wire::Slot slot : slots) {
    ddsi_sertype* type = make_described_type(slot);
    const std::string name(wire::slot_name(slot));
    const dds_entity_t topic =
        dds_create_topic_sertype(participant, name.c_str(), &type, nullptr, nullptr, nullptr);
    if (topic < 0) {
      ddsi_sertype_unref(type);
      return topic;
    }
    const dds_entity_t writer = dds_create_writer(publisher, topic, unmatched.get(), nullptr);
    if (writer < 0) return writer;
  }
  return DDS_RETCODE_OK;
}

}  // namespace skein::blackboard::cyclonedds
