// SPDX-License-Identifier: Apache-2.0
#include "skein/sim_node/sim_node.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "skein/blackboard/link_instance.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/journal/lines/radio.hpp"
#include "skein/journal/lines/truth.hpp"
#include "skein/translation/functional_layer.hpp"
#include "skein/translation/sensing.hpp"
#include "skein/translation/tasks.hpp"

namespace skein::sim {

namespace {

namespace lines = journal::lines;
using translation::for_journal;
using translation::from_wire;
using translation::to_wire;

std::string what_of(const Fault& fault) {
  switch (fault.kind) {
    case FaultKind::kEngine:
      return "engine";
    case FaultKind::kSensor:
      return "sensor " + fault.device;
    case FaultKind::kSlow:
      return "slow";
    case FaultKind::kAbort:
      return "abort " + fault.type;
    case FaultKind::kEnergy:
      break;
  }
  return "energy";
}

}  // namespace

SimNode::SimNode(std::string name, SimulatorConfig config, node::Roster roster,
                 std::vector<ScheduledFault> faults)
    : name_(std::move(name)),
      roster_(std::move(roster)),
      simulator_(std::move(config)),
      faults_(faults.begin(), faults.end()) {}

node::Effects SimNode::handle(const node::Input& input, MissionTime now) {
  node::Effects out;
  run_due_faults(now, out);
  const bool born = std::holds_alternative<node::Started>(input);
  if (born && std::exchange(lived_before_, true)) {
    begin_anew(now, out);
    return out;
  }
  const auto mine = input_of(input);
  const node::Effects effects = translate(simulator_.handle(mine.value_or(Input(Tick{})), now));
  out.insert(out.end(), effects.begin(), effects.end());
  return out;
}

// The event log is told what became of the tasks, as truth; the decision nodes are not.
void SimNode::begin_anew(MissionTime now, node::Effects& out) {
  const node::Effects effects = translate(simulator_.handle(LayerForgot{}, now));
  std::copy_if(effects.begin(), effects.end(), std::back_inserter(out), [](const auto& effect) {
    const auto* send = std::get_if<node::Send>(&effect);
    return send == nullptr || !std::holds_alternative<wire::FunctionalStatus>(send->sample);
  });
}

std::optional<MissionTime> SimNode::next_wakeup() const {
  const auto step = simulator_.next_wakeup();
  return faults_.empty() ? step : earliest(step, faults_.front().at);
}

// What the simulator is told of: requests of the decision nodes, and their silence. A decision node
// in a new incarnation has forgotten what its vehicle does.
std::optional<Input> SimNode::input_of(const node::Input& input) {
  if (const auto* received = std::get_if<node::Received>(&input)) {
    const auto* request = std::get_if<wire::FunctionalRequest>(&received->sample);
    const node::Member* from = roster_.find(received->from);
    if (request != nullptr && from != nullptr) {
      FunctionalRequest mine{from->name, from_wire(*request)};
      lines_.note(mine.uav, mine.request);
      return mine;
    }
    if (const auto* truth = std::get_if<wire::Truth>(&received->sample)) {
      return VehicleElsewhere{truth->name, from_wire(truth->position)};
    }
  }
  if (const auto* reach = std::get_if<node::Reachability>(&input)) {
    return ContactLost{roster_.name_of(reach->peer), !reach->reachable, reach->restarted};
  }
  return std::nullopt;
}

void SimNode::run_due_faults(MissionTime now, node::Effects& out) {
  while (!faults_.empty() && faults_.front().at <= now) {
    const ScheduledFault due = faults_.front();
    faults_.pop_front();
    out.push_back(node::Log{journal::record_of(
        due.at, name_, lines::Fault{.what = what_of(due.fault), .target = due.fault.uav})});
    const node::Effects effects = translate(simulator_.handle(due.fault, now));
    out.insert(out.end(), effects.begin(), effects.end());
  }
}

node::Effects SimNode::translate(const std::vector<Effect>& effects) {
  node::Effects out;
  for (const Effect& effect : effects) {
    std::visit([&](const auto& one) { take(one, out); }, effect);
  }
  return out;
}

void SimNode::take(const FunctionalStatus& status, node::Effects& out) {
  if (auto line = lines_.line_of(status.at, name_, status.uav, status.status))
    out.push_back(node::Log{std::move(*line)});
  wire::FunctionalStatus sample = to_wire(status.uav, status.status);
  out.push_back(node::Send{number_of(status.uav), std::move(sample), MissionTime::max()});
}

void SimNode::take(const Telemetry& telemetry, node::Effects& out) const {
  out.push_back(node::Send{number_of(telemetry.uav), to_wire(telemetry), MissionTime::max()});
}

void SimNode::take(const PerceptionOut& out_of, node::Effects& out) const {
  out.push_back(
      node::Send{number_of(out_of.perception.uav), to_wire(out_of.perception), MissionTime::max()});
}

void SimNode::take(const LinkChange& link, node::Effects& out) const {
  wire::LinkState sample;
  const auto end_of = [this](const std::string& name) {
    return name == kEveryLink ? blackboard::kEverybody : number_of(name);
  };
  const node::NodeNumber from = end_of(link.from), to = end_of(link.to);
  sample.from = from.value();
  sample.to = to.value();
  sample.header.instance = blackboard::link_instance(from, to);
  sample.up = link.up;
  sample.latency = link.latency.count();
  sample.loss = link.up ? link.loss : 0;
  sample.capacity = link.capacity;
  out.push_back(node::Publish{sample});
  lines::Link line{.from = link.from, .to = link.to, .up = link.up};
  if (link.capacity > 0) line.capacity = link.capacity;
  out.push_back(node::Log{journal::record_of(link.at, name_, std::move(line))});
}

void SimNode::take(const VehicleTruth& truth, node::Effects& out) const {
  out.push_back(node::Publish{translation::truth_of(truth.uav, truth.state)});
  out.push_back(node::Log{translation::telemetry_line(truth.at, name_, truth.uav, truth.state)});
}

void SimNode::take(const ObjectTruth& truth, node::Effects& out) const {
  wire::Truth sample;
  sample.header.instance = translation::truth_instance(truth.name);
  sample.name = truth.name;
  sample.kind = truth.kind;
  sample.position = to_wire(truth.position);
  sample.radius = truth.radius;
  sample.active = truth.active;
  out.push_back(node::Publish{sample});
  lines::Object line{.name = truth.name,
                     .type = truth.kind,
                     .position = for_journal(truth.position),
                     .radius = truth.front ? journal::rounded(truth.radius) : truth.radius,
                     .active = truth.active};
  if (truth.front) {
    const world::Vector2& from = truth.front->ignition;
    line.breadth = journal::rounded(truth.front->breadth);
    line.ignition = journal::rounded({from.x(), from.y()});
  }
  out.push_back(node::Log{journal::record_of(truth.at, name_, std::move(line))});
}

node::NodeNumber SimNode::number_of(const std::string& name) const {
  const node::Member* member = roster_.find(name);
  SKEIN_EXPECTS(member != nullptr);
  return member->number;
}

}  // namespace skein::sim
