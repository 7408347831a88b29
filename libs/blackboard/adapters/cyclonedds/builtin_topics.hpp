// SPDX-License-Identifier: Apache-2.0
// Reading the built-in topics of Cyclone DDS.
#pragma once

#include <dds/dds.h>

#include <array>
#include <cstddef>
#include <memory>

namespace skein::blackboard::cyclonedds {

/// Calls `self.take_all(reader)` whenever the built-in topic has something new, until the
/// participant ends, which must be before `self` does. Negative: the reason why not.
template <class Discovery>
dds_return_t follow_builtin_topic(dds_entity_t participant, dds_entity_t topic, Discovery& self) {
  const std::unique_ptr<dds_listener_t, decltype(&dds_delete_listener)> listener(
      dds_create_listener(&self), &dds_delete_listener);
  dds_lset_data_available(listener.get(), [](dds_entity_t reader, void* one) {
    static_cast<Discovery*>(one)->take_all(reader);
  });
  return dds_create_reader(participant, topic, nullptr, listener.get());
}

/// Takes all samples: `take(sample, there)`, which is not there any more where `there` is false.
template <class Sample, class Take>
void take_builtin_samples(dds_entity_t reader, const Take& take) {
  constexpr std::size_t kAtOnce = 16;
  std::array<void*, kAtOnce> samples{};
  std::array<dds_sample_info_t, kAtOnce> infos;
  while (true) {
    const dds_return_t count = dds_take(reader, samples.data(), infos.data(), kAtOnce, kAtOnce);
    if (count <= 0) return;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
      take(*static_cast<const Sample*>(samples[i]),
           infos[i].valid_data && infos[i].instance_state == DDS_IST_ALIVE);
    dds_return_loan(reader, samples.data(), count);
  }
}

}  // namespace skein::blackboard::cyclonedds
