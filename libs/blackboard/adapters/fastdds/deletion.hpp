// SPDX-License-Identifier: Apache-2.0
// The end of publishers.
#pragma once

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>

namespace skein::blackboard::fastdds {

/// Deletes a publisher with its writers, whose histories it empties before: Fast DDS 2.9 gives the
/// samples of a writer that is deleted back one by one while its heartbeat still reads them, counts
/// up to the number of one that is gone, and neither ends again (docs/decisions/0107). False: Fast
/// DDS refuses it. No other thread may write meanwhile.
bool delete_publisher(eprosima::fastdds::dds::DomainParticipant& participant,
                      eprosima::fastdds::dds::Publisher* publisher);

}  // namespace skein::blackboard::fastdds
