// SPDX-License-Identifier: Apache-2.0
// Lines of the event log about joint tasks: kinds joint, role, role-task, place, scm, negotiation
// (docs/journal.md).
#pragma once

#include <string>

#include "skein/decision_node/messages.hpp"
#include "skein/journal/record.hpp"
#include "skein/translation/journal_lines.hpp"

namespace skein::joint_lines {

// Each is about a UAV: the writer, or one whose role the writer plays.

journal::Record line_of(const translation::Writer& writer, const std::string& uav,
                        const interaction::JointTaskStatus& status);
journal::Record line_of(const translation::Writer& writer, const std::string& uav,
                        const decision_node::ComponelChanged& changed);
journal::Record line_of(const translation::Writer& writer, const std::string& uav,
                        const decision_node::RoleTaskGiven& given);
journal::Record line_of(const translation::Writer& writer, const std::string& uav,
                        const decision_node::PlaceComputed& computed);
journal::Record line_of(const translation::Writer& writer, const std::string& uav,
                        const decision_node::ScmNoted& noted);
journal::Record line_of(const translation::Writer& writer, const std::string& uav,
                        const decision_node::NegotiationNoted& noted);

}  // namespace skein::joint_lines
