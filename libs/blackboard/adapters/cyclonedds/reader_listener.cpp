// SPDX-License-Identifier: Apache-2.0
// What readers of Cyclone DDS do with what comes.
#include "reader_listener.hpp"

#include <array>
#include <memory>

#include "sample_type.hpp"
#include "skein/blackboard/cdr.hpp"

namespace skein::blackboard::cyclonedds {

dds_entity_t ReaderListener::make_reader(dds_entity_t subscriber, dds_entity_t topic,
                                         const dds_qos_t& qos) {
  const std::unique_ptr<dds_listener_t, decltype(&dds_delete_listener)> listener(
      dds_create_listener(this), &dds_delete_listener);
  dds_lset_data_available(listener.get(), [](dds_entity_t reader, void* self) {
    static_cast<ReaderListener*>(self)->take_all(reader);
  });
  return dds_create_reader(subscriber, topic, &qos, listener.get());
}

void ReaderListener::take_all(dds_entity_t reader) {
  constexpr std::uint32_t kAtOnce = 16;
  std::array<ddsi_serdata*, kAtOnce> data{};
  std::array<dds_sample_info_t, kAtOnce> infos;
  bool any = false;
  while (true) {
    const dds_return_t count =
        dds_takecdr(reader, data.data(), kAtOnce, infos.data(), DDS_ANY_STATE);
    if (count <= 0) break;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      if (infos[i].valid_data) take(reader, *data[i], infos[i]);
      any = any || infos[i].valid_data;
      ddsi_serdata_unref(data[i]);
    }
  }
  if (any) mailbox_.notify();
}

void ReaderListener::take(dds_entity_t reader, const ddsi_serdata& data,
                          const dds_sample_info_t& info) {
  const auto bytes = bytes_of(data);
  if (tap_) {
    tap_({slot_, partition_of(reader, info.publication_handle), info.source_timestamp, bytes});
  }
  mailbox_.put({channel_, decode(slot_, bytes)});
}

/// Called in the thread that delivers to this reader, which is one at a time.
const std::string& ReaderListener::partition_of(dds_entity_t reader, dds_instance_handle_t writer) {
  const auto [found, fresh] = partitions_.try_emplace(writer);
  if (!fresh) return found->second;
  const std::unique_ptr<dds_builtintopic_endpoint_t, decltype(&dds_builtintopic_free_endpoint)>
      endpoint(dds_get_matched_publication_data(reader, writer), &dds_builtintopic_free_endpoint);
  std::uint32_t count = 0;
  char** names = nullptr;
  if (endpoint == nullptr || !dds_qget_partition(endpoint->qos, &count, &names)) {
    return found->second;
  }
  if (count > 0) found->second = names[0];
  for (std::uint32_t i = 0; i < count; ++i) dds_free(names[i]);
  dds_free(names);
  return found->second;
}

}  // namespace skein::blackboard::cyclonedds
