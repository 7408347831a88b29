// SPDX-License-Identifier: Apache-2.0
// To whom each kind of input goes.
#pragma once

#include "core.hpp"

namespace skein::decision_node {

/// One function for each kind of input. What the ground and other UAVs say of joint tasks goes past
/// the voice, which passes it on to the ground if that plays the role.
class Core::Inputs {
 public:
  explicit Inputs(Core& core) : core_(core) {}

  void operator()(const Started& started) const;
  void operator()(const Resumed&) const;
  void operator()(const Command& command) const;
  void operator()(const UnreadableCommand& command) const;
  void operator()(const PlaceTold& told) const;
  void operator()(const ElementaryRequest& asked) const;
  void operator()(const GroundTaskSeen& seen) const { core_.tell_task(seen.event); }
  void operator()(const StatusTold& told) const { core_.told(told.status); }
  void operator()(const SyncMessage& message) const { core_.execution_.take(message); }
  void operator()(const DegreeTold& told) const { core_.execution_.take(told); }
  void operator()(const world::Telemetry& telemetry) const;
  void operator()(const world::Perception& seen) const {
    core_.bus_.emit(PerceptionPassedOn{seen});
  }
  void operator()(const LayerForgot& forgot) const;
  void operator()(const Contact& contact) const;
  void operator()(const supervisor::JobFinished& done) const {
    core_.deliberation_.job_finished(done);
  }
  void operator()(const interaction::SessionMessage& message) const { hear(message); }
  void operator()(const PartnerSeen& seen) const { hear(seen); }
  void operator()(const JointTaskTold& told) const { hear(told); }
  void operator()(const GroundNegotiates& said) const { core_.voice_.say(said); }
  void operator()(const GroundPlays& said) const { core_.voice_.say(said); }
  void operator()(const ReckoningFinished& done) const { core_.interaction_.reckoned(done); }
  void operator()(const DetoursPlanned& done) const { core_.team_.detours_planned(done); }
  void operator()(const TeamTold& told) const { core_.team_.hear(told); }
  void operator()(const MergeTold& told) const { core_.merging_.hear(told); }
  void operator()(const WaySearched& done) const { core_.merging_.hear(done); }
  void operator()(const FrontierTold& told) const { core_.meetings_.hear(told); }
  void operator()(const Tick& tick) const;

 private:
  template <class Heard>
  void hear(const Heard& heard) const {
    if (!core_.voice_.passes_on(heard)) core_.interaction_.hear(heard);
  }

  Core& core_;
};

}  // namespace skein::decision_node
