// SPDX-License-Identifier: Apache-2.0
// The delivery classes as QoS of Fast DDS.
#pragma once

#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>

#include "adapters/rtps/pace.hpp"
#include "skein/blackboard/channel.hpp"
#include "skein/blackboard/fastdds_transport.hpp"

namespace skein::blackboard::fastdds {

/// Whether participants are heard that say that they leave (DepartureFilter). With keys, and where
/// a discovery server passes on what they say, they always are.
enum class Departures : std::uint8_t { kHeard, kLeftToTheLease };

/// UDP over the configured interfaces only; discovery as configured and, on this machine, also by
/// unicast, since a loopback interface need not have multicast. `number` is that of the participant
/// among those of its domain on this machine, below kParticipants.
eprosima::fastdds::dds::DomainParticipantQos participant_qos(
    const DdsConfig& config, std::uint32_t number, const rtps::Pace& pace = {},
    Departures departures = Departures::kHeard);

/// Source: spec 1.3 (table of classes); notes on limits and periods in the README.
eprosima::fastdds::dds::DataWriterQos writer_qos(wire::Slot slot, ChannelKind kind,
                                                 const rtps::Pace& pace = {});
eprosima::fastdds::dds::DataReaderQos reader_qos(wire::Slot slot, ChannelKind kind);

}  // namespace skein::blackboard::fastdds
