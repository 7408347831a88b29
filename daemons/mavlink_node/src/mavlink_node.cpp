// SPDX-License-Identifier: Apache-2.0
#include "skein/mavlink_node/mavlink_node.hpp"

#include <utility>

#include "skein/foundation/contract.hpp"
#include "skein/translation/sensing.hpp"
#include "skein/translation/tasks.hpp"

namespace skein::mavlink_node {

MavlinkNode::MavlinkNode(std::string name, std::string uav, node::Roster roster,
                         std::shared_ptr<Cockpit> cockpit)
    : name_(std::move(name)), uav_(std::move(uav)), cockpit_(std::move(cockpit)) {
  const node::Member* self = roster.find(name_);
  const node::Member* peer = roster.find(uav_);
  SKEIN_EXPECTS(self != nullptr && peer != nullptr);
  self_ = self->number;
  peer_ = peer->number;
}

node::Effects MavlinkNode::handle(const node::Input& input, MissionTime now) {
  node::Effects out;
  if (const auto* reach = std::get_if<node::Reachability>(&input)) {
    if (reach->peer == peer_)
      cockpit_->give(autopilot::ContactLost{!reach->reachable, reach->restarted});
  } else if (const auto* received = std::get_if<node::Received>(&input)) {
    const auto* request = std::get_if<wire::FunctionalRequest>(&received->sample);
    if (request != nullptr && received->from == peer_) {
      const functional::Request asked = translation::from_wire(*request);
      lines_.note(uav_, asked);
      cockpit_->give(asked);
    } else if (received->from == self_) {
      relay(received->sample, now, out);
    }
  }
  return out;
}

void MavlinkNode::relay(wire::Sample sample, MissionTime now, node::Effects& out) {
  if (const auto* said = std::get_if<wire::JournalEntry>(&sample)) {
    if (auto record = journal::parse_record(said->record))
      out.push_back(node::Log{std::move(*record)});
    return;
  }
  if (const auto* status = std::get_if<wire::FunctionalStatus>(&sample)) {
    if (auto line = lines_.line_of(now, name_, uav_, translation::from_wire(*status)))
      out.push_back(node::Log{std::move(*line)});
  }
  if (const auto* telemetry = std::get_if<wire::Telemetry>(&sample)) {
    const world::VehicleState state = translation::from_wire(*telemetry).state;
    out.push_back(node::Publish{translation::truth_of(uav_, state)});
    out.push_back(node::Log{translation::telemetry_line(now, name_, uav_, state)});
  }
  wire::header_of(sample) = {};
  out.push_back(node::Send{peer_, std::move(sample), MissionTime::max()});
}

}  // namespace skein::mavlink_node
