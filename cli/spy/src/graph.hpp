// SPDX-License-Identifier: Apache-2.0
// Who takes part in a domain, and with what.
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

/// As sightings tell it. Only values, no clock.
class Graph {
 public:
  void see(const blackboard::Sighting& sighting, Duration now);
  /// The writer is that of a sample that came, which this node made (0: none of ours did); a
  /// directory entry says which node the writer belongs to.
  void hear(const std::string& writer, Duration at, std::uint32_t origin,
            const wire::DirectoryEntry* entry);

  /// By guid; only who is still there.
  const std::map<std::string, Taking>& participants() const { return participants_; }
  const std::map<std::string, blackboard::Endpoint>& endpoints() const { return endpoints_; }
  /// By node number; also of those who have left.
  const std::map<std::uint32_t, wire::DirectoryEntry>& directory() const { return directory_; }
  const blackboard::Endpoint* endpoint(const std::string& guid) const;
  /// When the endpoint was found.
  std::optional<Duration> found(const std::string& guid) const;

  /// The node's name by its directory entry; as long as none was heard that of the participant
  /// whom its samples came from, unless that is known to be another node; else "node 7".
  std::string name_of(std::uint32_t number) const;
  /// Of a participant: its node's name, else its own, else its guid. Also of one that has left.
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
