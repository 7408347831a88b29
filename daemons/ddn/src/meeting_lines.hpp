// SPDX-License-Identifier: Apache-2.0
// Lines of the event log about meetings with other UAVs (docs/journal.md).
#pragma once

#include "skein/decision_node/messages.hpp"
#include "skein/translation/journal_lines.hpp"

namespace skein::ddn {

/// `meeting`.
journal::Record line_of(const translation::Writer& writer,
                        const decision_node::MeetingNoted& noted);

}  // namespace skein::ddn
