// SPDX-License-Identifier: Apache-2.0
// The writers that others have, as Cyclone DDS finds them.
#include "writer_discovery.hpp"

#include <cstring>
#include <string>
#include <vector>

#include "builtin_topics.hpp"

namespace skein::blackboard::cyclonedds {
namespace {

std::vector<std::string> partitions_of(const dds_builtintopic_endpoint_t& endpoint) {
  std::uint32_t count = 0;
  char** names = nullptr;
  if (endpoint.qos == nullptr || !dds_qget_partition(endpoint.qos, &count, &names)) return {};
  std::vector<std::string> partitions(names, names + count);
  for (std::uint32_t i = 0; i < count; ++i) dds_free(names[i]);
  dds_free(names);
  return partitions;
}

}  // namespace

dds_return_t WriterDiscovery::begin(dds_entity_t participant) {
  if (const dds_return_t known = dds_get_guid(participant, &own_); known < 0) return known;
  return follow_builtin_topic(participant, DDS_BUILTIN_TOPIC_DCPSPUBLICATION, *this);
}

void WriterDiscovery::take_all(dds_entity_t reader) {
  take_builtin_samples<dds_builtintopic_endpoint_t>(reader, [this](const auto& writer, bool there) {
    const bool own = std::memcmp(writer.participant_key.v, own_.v, sizeof own_.v) == 0;
    const bool named = writer.topic_name != nullptr && writer.type_name != nullptr;
    if (there && !own && named)
      awaited_.found(writer.topic_name, writer.type_name, partitions_of(writer));
  });
}

}  // namespace skein::blackboard::cyclonedds
