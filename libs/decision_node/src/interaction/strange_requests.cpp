// SPDX-License-Identifier: Apache-2.0
#include "interaction/strange_requests.hpp"

#include <cmath>
#include <utility>

namespace skein::decision_node {

using interaction::JointPhase;

namespace {

constexpr Duration kLong = Duration::milliseconds(60'000);

}  // namespace

// They wait for it.
void StrangeRequests::decline(const Joint& joint, const std::string& why) {
  interaction::JointTaskStatus status = status_of(joint, host_.config().uav);
  status.phase = JointPhase::kNotLoaded;
  status.why = why;
  const JointTaskChanged told{std::move(status), joint.others(host_.config().uav)};
  declined_[joint.subject] = {host_.bus().now(), told};
  host_.bus().emit(told);
}

// Nobody would wait for it for less than ever.
void StrangeRequests::disown(interaction::JointTaskStatus status) {
  const std::string partner = std::exchange(status.uav, host_.config().uav);
  status.task = 0;
  status.phase = JointPhase::kAborted;
  status.why = "it knows nothing of this any more";
  status.active_blocks.clear();
  status.violated.clear();
  status.left.clear();
  host_.bus().emit(JointTaskChanged{std::move(status), {partner}});
}

void StrangeRequests::hear(const interaction::Terms& terms,
                           const std::vector<const Joint*>& loading) {
  const std::string asked = terms.subject.substr(0, terms.subject.rfind('/'));
  const auto known = declined_.find(asked);
  if (known != declined_.end()) host_.bus().emit(known->second.told);
  bool is_otherwise = false;
  for (const Joint* joint : loading) {
    const auto different = difference(*joint, asked);
    if (!different) continue;
    is_otherwise = true;
    const std::string text = "'" + terms.opener + "' asks for it with " + *different;
    if (std::exchange(otherwise_[joint->subject], text) != text)
      host_.bus().emit(Notice{joint->subject + ": " + text});
  }
  if (known == declined_.end() && !is_otherwise) ask_in_vain(terms, asked);
}

void StrangeRequests::ask_in_vain(const interaction::Terms& terms, const std::string& subject) {
  const MissionTime now = host_.bus().now();
  InVain& one = in_vain_.try_emplace(subject, InVain{now, now}).first->second;
  one.last = now;
  if (one.noted || now < one.first + kLong) return;
  one.noted = true;
  host_.bus().emit(Notice{"'" + terms.opener + "' has asked for " + subject + " since " +
                          std::to_string(std::lround(one.first.to_seconds())) + " s, and '" +
                          host_.config().uav + "' has no such goal"});
}

std::string StrangeRequests::asked_otherwise(const std::string& subject) const {
  const auto known = otherwise_.find(subject);
  return known == otherwise_.end() ? "" : known->second;
}

void StrangeRequests::forget(const std::set<std::string>& subjects, Duration after) {
  const MissionTime now = host_.bus().now();
  std::erase_if(otherwise_, [&](const auto& one) { return !subjects.contains(one.first); });
  std::erase_if(in_vain_, [&](const auto& one) { return one.second.last + after <= now; });
  std::erase_if(declined_, [&](const auto& one) { return one.second.at + after <= now; });
}

}  // namespace skein::decision_node
