// SPDX-License-Identifier: Apache-2.0
// Records of a UAV's part in its team (docs/journal.md).
#pragma once

#include "skein/decision_node/messages.hpp"
#include "skein/translation/journal_lines.hpp"

namespace skein::ddn {

journal::Record line_of(const translation::Writer& writer,
                        const decision_node::TeamTaskNoted& noted);
journal::Record line_of(const translation::Writer& writer, const decision_node::BidNoted& noted);
journal::Record line_of(const translation::Writer& writer, const decision_node::TokenNoted& noted);

}  // namespace skein::ddn
