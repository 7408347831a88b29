// SPDX-License-Identifier: Apache-2.0
// Lines of the event log about reservations of air (docs/journal.md).
#pragma once

#include "skein/decision_node/messages.hpp"
#include "skein/translation/journal_lines.hpp"

namespace skein::ddn {

/// `air`.
journal::Record line_of(const translation::Writer& writer, const decision_node::AirNoted& noted);

}  // namespace skein::ddn
