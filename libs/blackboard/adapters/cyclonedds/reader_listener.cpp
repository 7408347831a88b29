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
  const dds_entity_t reader = dds_create_reader(subscriber, topic, &qos, listener.get());
  // What came before it was whole was announced when nothing could be taken from it yet.
  if (reader > 0) take_all(reader);
  return reader;
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
      if (infos[i].valid_data) mailbox_.put({channel_, decode(slot_, bytes_of(*data[i]))});
      any = any || infos[i].valid_data;
      ddsi_serdata_unref(data[i]);
    }
  }
  if (any) mailbox_.notify();
}

}  // namespace skein::blackboard::cyclonedds
