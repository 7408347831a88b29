// SPDX-License-Identifier: Apache-2.0
// The one factory of participants of a process.
#pragma once

#include <fastdds/dds/domain/DomainParticipantFactory.hpp>

namespace skein::blackboard::fastdds {

/// No profile file on the way to a participant may change what this process does.
eprosima::fastdds::dds::DomainParticipantFactory& factory();

}  // namespace skein::blackboard::fastdds
