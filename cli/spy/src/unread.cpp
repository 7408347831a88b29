// SPDX-License-Identifier: Apache-2.0
#include "unread.hpp"

#include <algorithm>
#include <map>

namespace skein::spy_tool {

void Unread::see(const blackboard::Sighting& sighting) {
  const auto* seen = std::get_if<blackboard::EndpointSeen>(&sighting);
  if (seen == nullptr) return;
  const blackboard::Endpoint& endpoint = seen->endpoint;
  (endpoint.writer ? writers_ : readers_).insert({endpoint.topic, endpoint.partitions});
}

std::vector<std::string> Unread::topics() const {
  std::map<std::string, bool> is_read;
  for (const Place& writer : writers_)
    is_read[writer.topic] |= std::ranges::any_of(readers_, [&](const Place& reader) {
      return reader.topic == writer.topic &&
             blackboard::partitions_meet(writer.partitions, reader.partitions);
    });
  std::vector<std::string> unread;
  for (const auto& [topic, read] : is_read)
    if (!read) unread.push_back(topic);
  return unread;
}

}  // namespace skein::spy_tool
