// SPDX-License-Identifier: Apache-2.0
// The simulator as a node: samples and records around the Simulator component.
#pragma once

#include <deque>
#include <memory>

#include "skein/node/node.hpp"
#include "skein/node/roster.hpp"
#include "skein/sim/simulator.hpp"
#include "skein/translation/functional_layer.hpp"

namespace skein::sim {

/// A fault on board at an instant of the mission.
struct ScheduledFault {
  MissionTime at;
  Fault fault;
};

/// Functional requests in; functional statuses, telemetry and perceptions out to each UAV; link
/// states and ground truth out to the world; ground truth to the event log, with what the
/// functional layer of each vehicle really does.
///
/// If it starts in a new incarnation after inputs of a former one, it acts as a functional layer
/// that has lost its memory: vehicles and world are as those inputs left them, active tasks are
/// over, and their end is not reported.
class SimNode final : public node::Node {
 public:
  /// `name`: of this node, "sim" or a functional layer's. `faults` in order of time.
  SimNode(std::string name, SimulatorConfig config, node::Roster roster,
          std::vector<ScheduledFault> faults);

  node::Effects handle(const node::Input& input, MissionTime now) override;
  std::optional<MissionTime> next_wakeup() const override;

 private:
  node::Effects translate(const std::vector<Effect>& effects);
  void take(const FunctionalStatus& status, node::Effects& out);
  void take(const Telemetry& telemetry, node::Effects& out) const;
  void take(const PerceptionOut& perception, node::Effects& out) const;
  void take(const LinkChange& link, node::Effects& out) const;
  void take(const VehicleTruth& truth, node::Effects& out) const;
  void take(const ObjectTruth& truth, node::Effects& out) const;
  void begin_anew(MissionTime now, node::Effects& out);
  void run_due_faults(MissionTime now, node::Effects& out);
  std::optional<Input> input_of(const node::Input& input);
  node::NodeNumber number_of(const std::string& name) const;

  std::string name_;
  node::Roster roster_;
  Simulator simulator_;
  std::deque<ScheduledFault> faults_;
  bool lived_before_ = false;
  translation::FunctionalLines lines_;
};

}  // namespace skein::sim
