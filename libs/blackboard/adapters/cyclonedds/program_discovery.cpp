// SPDX-License-Identifier: Apache-2.0
// The programs that take part, as Cyclone DDS finds them.
#include "program_discovery.hpp"

#include <string>

#include "builtin_topics.hpp"

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
  return follow_builtin_topic(participant, DDS_BUILTIN_TOPIC_DCPSPARTICIPANT, *this);
}

void ProgramDiscovery::take_all(dds_entity_t reader) {
  take_builtin_samples<dds_builtintopic_participant_t>(reader, [this](const auto& one, bool there) {
    if (there) {
      programs_->found(text_of(one.key), name_of(one), description_of(one));
    } else {
      programs_->gone(text_of(one.key));
    }
  });
}

}  // namespace skein::blackboard::cyclonedds
