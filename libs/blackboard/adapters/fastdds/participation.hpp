// SPDX-License-Identifier: Apache-2.0
// Taking part in a domain.
#pragma once

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>

#include <optional>
#include <string>

#include "adapters/rtps/pace.hpp"
#include "adapters/rtps/participant_number.hpp"
#include "qos.hpp"
#include "security.hpp"
#include "skein/blackboard/dds_config.hpp"

namespace skein::blackboard::fastdds {

/// A participant with its number and listener. Profile files of Fast DDS have no effect on it.
class Participation {
 public:
  Participation() = default;
  Participation(const Participation&) = delete;
  Participation& operator=(const Participation&) = delete;
  /// Deletes the participant and all its entities.
  ~Participation();

  /// Joins the domain; to be called once. The listener (may be null) must outlive this object. The
  /// failure names all errors of the configuration.
  Result<void, Failure> join(const DdsConfig& config,
                             eprosima::fastdds::dds::DomainParticipantListener* listener,
                             const rtps::Pace& pace = {},
                             Departures departures = Departures::kHeard);
  eprosima::fastdds::dds::DomainParticipant* participant() const { return participant_; }
  /// The folder with this node's keys; empty: the domain is not secured.
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
