// SPDX-License-Identifier: Apache-2.0
// DDS-Security as Fast DDS has it: what a participant proves itself with, and who the others are.
#pragma once

#include <fastdds/rtps/attributes/PropertyPolicy.h>
#include <fastdds/rtps/common/GuidPrefix_t.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "skein/foundation/result.hpp"

namespace skein::blackboard::fastdds {

/// The properties of a participant whose keys are in the folder; the failure names every file that
/// is missing there.
Result<eprosima::fastrtps::rtps::PropertyPolicy, Failure> security_properties(
    const std::string& folder);

/// Maps GUIDs to nodes: the first six bytes of a secured participant's GUID follow from the
/// subject of its certificate, which the handshake verifies. Fast DDS 2.9 checks what a remote
/// participant writes by topic only, not by partition; with this map the blackboard knows the
/// writing node. Source: DDS-Security 1.1, 9.3.3 (participant_key).
class Identities {
 public:
  /// Of the file `nodes` in the folder: a name and twelve hexadecimal digits in each line.
  static Result<Identities, Failure> read(const std::string& folder);
  /// Whether a participant with this GUID may speak as the node `name`.
  bool confirm(const std::string& name, const eprosima::fastrtps::rtps::GuidPrefix_t& guid) const;

 private:
  using Mark = std::array<std::uint8_t, 6>;
  std::map<std::string, Mark, std::less<>> marks_;
};

}  // namespace skein::blackboard::fastdds
