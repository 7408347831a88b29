// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/joint_tasks.hpp"

namespace skein::translation {

namespace {

std::vector<wire::Parameter> to_wire(const interaction::Rows& rows) {
  std::vector<wire::Parameter> result;
  for (const interaction::Row& row : rows) result.push_back({row.name, row.text, row.numbers});
  return result;
}

interaction::Rows from_wire(const std::vector<wire::Parameter>& parameters) {
  interaction::Rows rows;
  for (const wire::Parameter& one : parameters) rows.push_back({one.name, one.text, one.numbers});
  return rows;
}

}  // namespace

// ---- negotiations ----

wire::NegotiationMessage to_wire(const interaction::SessionMessage& message,
                                 const std::string& to) {
  const interaction::Terms& terms = message.terms;
  wire::NegotiationMessage result;
  result.from = message.from;
  result.to = to;
  result.subject = terms.subject;
  result.mission_id = terms.mission;
  result.modality = terms.modality;
  result.members = terms.members;
  result.model = terms.model.value;
  result.parameters = to_wire(terms.parameters);
  result.opener = terms.opener;
  result.opened = terms.opened.count();
  result.deadline = terms.deadline.count();
  for (const interaction::Entry& entry : message.entries) {
    result.entries.push_back({entry.uav, entry.offered, to_wire(entry.offer),
                              static_cast<wire::NegotiationVow>(entry.vow), entry.result, entry.why,
                              entry.lost});
  }
  result.wants_echo = message.wants_echo;
  return result;
}

interaction::SessionMessage from_wire(const wire::NegotiationMessage& sample) {
  interaction::SessionMessage message;
  message.from = sample.from;
  interaction::Terms& terms = message.terms;
  terms.subject = sample.subject;
  terms.mission = sample.mission_id;
  terms.modality = sample.modality;
  terms.members = sample.members;
  terms.model.value = sample.model;
  terms.parameters = from_wire(sample.parameters);
  terms.opener = sample.opener;
  terms.opened = MissionTime::nanoseconds(sample.opened);
  terms.deadline = MissionTime::nanoseconds(sample.deadline);
  for (const wire::NegotiationEntry& entry : sample.entries) {
    message.entries.push_back({entry.uav, entry.offered, from_wire(entry.offer),
                               static_cast<interaction::Entry::Vow>(entry.vow), entry.fingerprint,
                               entry.why, entry.lost});
  }
  message.wants_echo = sample.wants_echo;
  return message;
}

// ---- joint tasks ----

wire::JointTaskState to_wire(const interaction::JointTaskStatus& status) {
  wire::JointTaskState result;
  result.header.instance = static_cast<std::uint32_t>(status.task);
  result.uav = status.uav;
  result.subject = status.subject;
  result.task = status.task;
  result.model = status.model;
  result.variant = status.variant;
  result.model_hash = status.hash.value;
  result.phase = static_cast<wire::JointTaskPhase>(status.phase);
  result.why = status.why;
  for (const auto& [uav, role] : status.holders) result.holders.push_back({uav, role});
  result.active_blocks = status.active_blocks;
  result.violated = status.violated;
  if (status.agreed_start) result.agreed_start = status.agreed_start->count();
  result.left = to_wire(status.left);
  return result;
}

interaction::JointTaskStatus from_wire(const wire::JointTaskState& sample) {
  interaction::JointTaskStatus status;
  status.uav = sample.uav;
  status.subject = sample.subject;
  status.task = sample.task;
  status.model = sample.model;
  status.variant = sample.variant;
  status.hash.value = sample.model_hash;
  status.phase = static_cast<interaction::JointPhase>(sample.phase);
  status.why = sample.why;
  for (const wire::RoleHolder& one : sample.holders) status.holders[one.uav] = one.role;
  status.active_blocks = sample.active_blocks;
  status.violated = sample.violated;
  if (sample.agreed_start != wire::kNoInstant) {
    status.agreed_start = MissionTime::nanoseconds(sample.agreed_start);
  }
  status.left = from_wire(sample.left);
  return status;
}

}  // namespace skein::translation
