// SPDX-License-Identifier: Apache-2.0
// Messages of plan merging: wire to domain and back.
#pragma once

#include "skein/merging/message.hpp"
#include "skein/translation/missions.hpp"

namespace skein::translation {

wire::MergeMessage to_wire(const merging::Message& message);

/// Refuses volumes without extent. The author of the message is its sender.
Read<merging::Message> from_wire(const wire::MergeMessage& sample);

}  // namespace skein::translation
