// SPDX-License-Identifier: Apache-2.0
// The decision node (DDN) of one UAV as one pure component.
#pragma once

#include <memory>
#include <optional>

#include "skein/decision_node/config.hpp"
#include "skein/decision_node/messages.hpp"

namespace skein::decision_node {

class Core;

/// A DDN (T II): between the ground station and the functional layer of one UAV.
///
/// - Degree 1: a transparent connecting point. Elementary requests of the ground go to the
///   functional layer, its statuses and synchronisation messages of others go to the ground.
/// - Degree 2: the MLE runs partially ordered plans; its synchronisation messages go to the ground,
///   which relays them.
/// - Degree 3: synchronisation messages go directly to the MLE of the other UAV.
/// - Degree 4: the supervisor plans missions and feeds the MLE; its jobs go to the runtime, and
///   everything is answered while they run.
///
/// The ground may change the degree at any time. Each change is answered with the plan in hand at
/// that moment (HandedOver). Between degrees 2 and 4 running tasks go on, since the executive on
/// board keeps them. A change to degree 1 hands the tasks, with their ids, to the ground's
/// executive; a change from degree 1 brings them back by START. With `interrupt` all tasks are
/// aborted, the highest id first, and a vehicle in the air waits.
///
/// At every degree telemetry and perceptions are passed on to the ground, and the MLE on board
/// carries out the contact-loss policy. The tasks of that policy have ids from
/// functional::kFirstOwnId on, numbered by the millisecond of the mission in which they were made,
/// so that a restarted node does not use an id twice. At degree 4 the supervisor then stops
/// deciding until the ground sets the degree again. Tasks of the policy yield to any task that
/// moves the vehicle: they are aborted, and the new task is dispatched after their end.
///
/// A command is executed once: repeated with the same number, from the same life of the ground
/// station, it only gets the same answer again.
///
/// Components: executive, supervisor and interaction manager. A table routes requests to them
/// (src/routes.hpp); events are broadcast to all of them (src/component.hpp).
///
/// `now` never decreases. Deterministic. Not safe to share between threads.
/// Source: T II.2, T III, T IV.4, spec 1.2, 1.5, 6.2.
class DecisionNode {
 public:
  /// Precondition: the fields of `config` are as Config requires.
  explicit DecisionNode(Config config);
  ~DecisionNode();
  DecisionNode(DecisionNode&&) noexcept;
  DecisionNode& operator=(DecisionNode&&) noexcept;

  Effects handle(const Input& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

 private:
  std::unique_ptr<Core> core_;
};

}  // namespace skein::decision_node
