// SPDX-License-Identifier: Apache-2.0
// Lines of the event log about what a decision node does as a whole: kinds request, sync, contact,
// notice, goal (docs/journal.md).
#pragma once

#include "skein/decision_node/messages.hpp"
#include "skein/translation/journal_lines.hpp"

namespace skein::ddn {

// The writer is the UAV that the line is about.

journal::Record line_of(const translation::Writer& writer,
                        const decision_node::RequestHandled& handled);
journal::Record line_of(const translation::Writer& writer, const decision_node::SyncHeard& heard);
journal::Record line_of(const translation::Writer& writer,
                        const decision_node::PolicyCarriedOut& policy);
journal::Record line_of(const translation::Writer& writer, const decision_node::Notice& notice);
journal::Record line_of(const translation::Writer& writer, const supervisor::GoalChanged& changed);

}  // namespace skein::ddn
