// SPDX-License-Identifier: Apache-2.0
// Lines of the event log about joint tasks: kinds joint, role, role-task, place, scm, negotiation
// (docs/journal.md).
#pragma once

#include "skein/decision_node/messages.hpp"
#include "skein/journal/record.hpp"
#include "skein/translation/journal_lines.hpp"

namespace skein::ddn {

// The writer is the UAV that the line is about.

journal::Record line_of(const translation::Writer& writer,
                        const interaction::JointTaskStatus& status);
journal::Record line_of(const translation::Writer& writer,
                        const decision_node::ComponelChanged& changed);
journal::Record line_of(const translation::Writer& writer,
                        const decision_node::RoleTaskGiven& given);
journal::Record line_of(const translation::Writer& writer,
                        const decision_node::PlaceComputed& computed);
journal::Record line_of(const translation::Writer& writer, const decision_node::ScmNoted& noted);
journal::Record line_of(const translation::Writer& writer,
                        const decision_node::NegotiationNoted& noted);

}  // namespace skein::ddn
