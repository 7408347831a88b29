// SPDX-License-Identifier: Apache-2.0
#include "graph.hpp"

#include "skein/blackboard/dds_type.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::spy_tool {

using blackboard::Endpoint;

namespace {

/// Of what is announced of a topic's type: it says nothing else, and matches nobody.
bool only_describes(const Endpoint& endpoint) {
  return endpoint.writer &&
         endpoint.partitions == std::vector<std::string>{blackboard::kTypesPartition};
}

}  // namespace

void Graph::see(const blackboard::Sighting& sighting, Duration now) {
  std::visit(Overloaded{[&](const blackboard::ParticipantSeen& seen) {
                          auto [place, fresh] = participants_.try_emplace(seen.participant.guid);
                          place->second.participant = seen.participant;
                          if (fresh) place->second.since = now;
                          names_[seen.participant.guid] = seen.participant.name;
                        },
                        [&](const blackboard::ParticipantGone& gone) {
                          participants_.erase(gone.guid);
                          std::erase_if(endpoints_, [&](const auto& one) {
                            if (one.second.participant != gone.guid) return false;
                            found_.erase(one.first);
                            return true;
                          });
                        },
                        [&](const blackboard::EndpointSeen& seen) {
                          if (only_describes(seen.endpoint)) return;
                          endpoints_.insert_or_assign(seen.endpoint.guid, seen.endpoint);
                          found_.try_emplace(seen.endpoint.guid, now);
                        },
                        [&](const blackboard::EndpointGone& gone) {
                          endpoints_.erase(gone.guid);
                          found_.erase(gone.guid);
                        },
                        [](const blackboard::SampleSeen&) {}},
             sighting);
}

void Graph::hear(const std::string& writer, Duration at, std::uint32_t origin,
                 const wire::DirectoryEntry* entry) {
  if (entry != nullptr) directory_.insert_or_assign(entry->header.origin, *entry);
  const std::string participant = writer.substr(0, writer.find('.'));
  if (origin != 0) speakers_.try_emplace(origin, participant);
  const auto found = participants_.find(participant);
  if (found == participants_.end()) return;
  found->second.heard = at;
  if (entry != nullptr) found->second.node = entry->header.origin;
}

const Endpoint* Graph::endpoint(const std::string& guid) const {
  const auto found = endpoints_.find(guid);
  return found == endpoints_.end() ? nullptr : &found->second;
}

std::optional<Duration> Graph::found(const std::string& guid) const {
  const auto found = found_.find(guid);
  return found == found_.end() ? std::nullopt : std::optional(found->second);
}

std::string Graph::name_of(std::uint32_t number) const {
  const auto found = directory_.find(number);
  if (found != directory_.end()) return found->second.name;
  const auto speaker = speakers_.find(number);
  const auto taking =
      speaker == speakers_.end() ? participants_.end() : participants_.find(speaker->second);
  const bool named = taking != participants_.end() && !taking->second.node &&
                     !taking->second.participant.name.empty();
  return named ? taking->second.participant.name : "node " + std::to_string(number);
}

std::string Graph::owner_of(const std::string& participant) const {
  const auto taking = participants_.find(participant);
  if (taking != participants_.end() && taking->second.node) return name_of(*taking->second.node);
  const auto named = names_.find(participant);
  return named == names_.end() || named->second.empty() ? participant : named->second;
}

std::vector<const Endpoint*> Graph::of_topic(const std::string& topic, bool writers) const {
  std::vector<const Endpoint*> all;
  for (const auto& [guid, endpoint] : endpoints_)
    if (endpoint.topic == topic && endpoint.writer == writers) all.push_back(&endpoint);
  return all;
}

}  // namespace skein::spy_tool
