// SPDX-License-Identifier: Apache-2.0
// The programs that take part, as Cyclone DDS finds them.
#include "program_discovery.hpp"

#include <array>
#include <string>

namespace skein::blackboard::cyclonedds {
namespace {

std::string text_of(const dds_guid_t& guid) {
  return {reinterpret_cast<const char*>(guid.v), sizeof guid.v};
}

std::string name_of(const dds_builtintopic_participant_t& participant) {
  char* name = nullptr;
  if (participant.qos == nullptr || !dds_qget_entity_name(participant.qos, &name)) return {};
  std::string text = name == nullptr ? "" : name;
  dds_free(name);
  return text;
}

std::string description_of(const dds_builtintopic_participant_t& participant) {
  void* said = nullptr;
  std::size_t size = 0;
  if (participant.qos == nullptr || !dds_qget_userdata(participant.qos, &said, &size)) return {};
  std::string text =
      said == nullptr ? std::string() : std::string(static_cast<const char*>(said), size);
  dds_free(said);
  return text;
}

}  // namespace

dds_return_t ProgramDiscovery::begin(dds_entity_t participant) {
  if (programs_ == nullptr) return DDS_RETCODE_OK;
  const std::unique_ptr<dds_listener_t, decltype(&dds_delete_listener)> listener(
      dds_create_listener(this), &dds_delete_listener);
  dds_lset_data_available(listener.get(), [](dds_entity_t reader, void* self) {
    static_cast<ProgramDiscovery*>(self)->take_all(reader);
  });
  return dds_create_reader(participant, DDS_BUILTIN_TOPIC_DCPSPARTICIPANT, nullptr, listener.get());
}

void ProgramDiscovery::take_all(dds_entity_t reader) {
  constexpr std::size_t kAtOnce = 16;
  std::array<void*, kAtOnce> samples{};
  std::array<dds_sample_info_t, kAtOnce> infos;
  while (true) {
    const dds_return_t count = dds_take(reader, samples.data(), infos.data(), kAtOnce, kAtOnce);
    if (count <= 0) return;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      const auto& one = *static_cast<const dds_builtintopic_participant_t*>(samples[i]);
      if (infos[i].valid_data && infos[i].instance_state == DDS_IST_ALIVE) {
        programs_->found(text_of(one.key), name_of(one), description_of(one));
      } else {
        programs_->gone(text_of(one.key));
      }
    }
    dds_return_loan(reader, samples.data(), count);
  }
}

}  // namespace skein::blackboard::cyclonedds
