// SPDX-License-Identifier: Apache-2.0
// Participants of a domain, and their endpoints.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/blackboard/observer.hpp"
#include "skein/blackboard/wire.hpp"

namespace skein::spy_tool {

struct Taking {
  blackboard::Participant participant;
  Duration since;                     ///< steady; when it was found
  std::optional<Duration> heard;      ///< steady; its last sample
  std::optional<std::uint32_t> node;  ///< by its directory entry
};

/// The domain according to sightings. A value type without a clock.
class Graph {
 public:
  void see(const blackboard::Sighting& sighting, Duration now);
  /// Takes a received sample of a writer. `origin`: the node that made it (0: none of ours); a
  /// directory entry tells which node the writer belongs to.
  void hear(const std::string& writer, Duration at, std::uint32_t origin,
            const wire::DirectoryEntry* entry);

  /// Current participants, by guid.
  const std::map<std::string, Taking>& participants() const { return participants_; }
  const std::map<std::string, blackboard::Endpoint>& endpoints() const { return endpoints_; }
  /// Directory entries by node number, including nodes that have left.
  const std::map<std::uint32_t, wire::DirectoryEntry>& directory() const { return directory_; }
  const blackboard::Endpoint* endpoint(const std::string& guid) const;
  /// When the endpoint was found.
  std::optional<Duration> found(const std::string& guid) const;

  /// The node's name from its directory entry; without one that of the participant that sent its
  /// samples, unless that is known to be another node; else "node 7".
  std::string name_of(std::uint32_t number) const;
  /// Name of a participant, present or past: its node's name, else its own, else its guid.
  std::string owner_of(const std::string& participant) const;

  std::vector<const blackboard::Endpoint*> of_topic(const std::string& topic, bool writers) const;

 private:
  std::map<std::string, Taking> participants_;
  std::map<std::string, std::string> names_;  ///< of participants, also of those who left
  std::map<std::string, blackboard::Endpoint> endpoints_;
  std::map<std::string, Duration> found_;
  std::map<std::uint32_t, wire::DirectoryEntry> directory_;
  std::map<std::uint32_t, std::string> speakers_;  ///< by node: a participant's guid
};

}  // namespace skein::spy_tool
