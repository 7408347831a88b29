// SPDX-License-Identifier: Apache-2.0
// What UAVs tell each other to merge their ways: wire to domain and back.
#pragma once

#include "skein/merging/message.hpp"
#include "skein/translation/missions.hpp"

namespace skein::translation {

wire::MergeMessage to_wire(const merging::Message& message);

/// Refuses air without extent. Whose message it is, is said by who sent it.
Read<merging::Message> from_wire(const wire::MergeMessage& sample);

}  // namespace skein::translation
