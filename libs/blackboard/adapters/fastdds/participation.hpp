// SPDX-License-Identifier: Apache-2.0
// Taking part in a domain.
#pragma once

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>

#include <optional>
#include <string>

#include "adapters/rtps/pace.hpp"
#include "adapters/rtps/participant_number.hpp"
#include "security.hpp"
#include "skein/blackboard/dds_config.hpp"

namespace skein::blackboard::fastdds {

/// A participant, and what is held for it. No profile file on the way to it has any effect.
class Participation {
 public:
  Participation() = default;
  Participation(const Participation&) = delete;
  Participation& operator=(const Participation&) = delete;
  /// Takes leave with all that the participant contains.
  ~Participation();

  /// Once. The listener, which may be null, outlives it. The failure says all that is wrong with
  /// the configuration.
  Result<void, Failure> join(const DdsConfig& config,
                             eprosima::fastdds::dds::DomainParticipantListener* listener,
                             const rtps::Pace& pace = {});
  eprosima::fastdds::dds::DomainParticipant* participant() const { return participant_; }
  /// The folder with this node's; empty: the domain is open to anybody.
  const std::string& keys() const { return keys_; }
  /// Of a secured domain.
  const std::optional<Identities>& identities() const { return identities_; }

 private:
  std::string keys_;
  std::optional<rtps::ParticipantNumber> number_;
  std::optional<Identities> identities_;
  eprosima::fastdds::dds::DomainParticipant* participant_ = nullptr;
};

}  // namespace skein::blackboard::fastdds
