// SPDX-License-Identifier: Apache-2.0
// The writers that others have, as Cyclone DDS finds them.
#include "writer_discovery.hpp"

#include <array>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

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
  const std::unique_ptr<dds_listener_t, decltype(&dds_delete_listener)> listener(
      dds_create_listener(this), &dds_delete_listener);
  dds_lset_data_available(listener.get(), [](dds_entity_t reader, void* self) {
    static_cast<WriterDiscovery*>(self)->take_all(reader);
  });
  return dds_create_reader(participant, DDS_BUILTIN_TOPIC_DCPSPUBLICATION, nullptr, listener.get());
}

void WriterDiscovery::take_all(dds_entity_t reader) {
  constexpr std::size_t kAtOnce = 16;
  std::array<void*, kAtOnce> samples{};
  std::array<dds_sample_info_t, kAtOnce> infos;
  while (true) {
    const dds_return_t count = dds_take(reader, samples.data(), infos.data(), kAtOnce, kAtOnce);
    if (count <= 0) return;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      const auto& writer = *static_cast<const dds_builtintopic_endpoint_t*>(samples[i]);
      const bool there = infos[i].valid_data && infos[i].instance_state == DDS_IST_ALIVE;
      const bool own = std::memcmp(writer.participant_key.v, own_.v, sizeof own_.v) == 0;
      const bool named = writer.topic_name != nullptr && writer.type_name != nullptr;
      if (there && !own && named)
        awaited_.found(writer.topic_name, writer.type_name, partitions_of(writer));
    }
    dds_return_loan(reader, samples.data(), count);
  }
}

}  // namespace skein::blackboard::cyclonedds
