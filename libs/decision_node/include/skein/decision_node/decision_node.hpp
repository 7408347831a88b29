// SPDX-License-Identifier: Apache-2.0
// The decision making of one UAV as one component.
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
/// - Degree 3: they go straight to the MLE of the other UAV.
/// - Degree 4: the supervisor plans missions and feeds the MLE; its jobs go to the runtime, and
///   everything is answered while they run.
///
/// The degree is changed by the ground at any time. Each change is answered with the plan that is
/// held at that moment (HandedOver). Degrees 2 to 4 execute here, so what runs goes on; at degree 1
/// the ground's executive takes over what the one here gives up, under the same ids, and brings it
/// back by START. With `interrupt` all is aborted, the highest id first, and what flies waits.
///
/// At every degree telemetry and perceptions are passed on to the ground, and the contact-loss
/// policy is carried out by the MLE on board, with task ids from functional::kFirstOwnId, numbered
/// by the millisecond of the mission in which they were made, so that a node that was restarted
/// does not use a number twice; at degree 4 the supervisor then stops deciding until the ground
/// gives the degree again. Such own tasks give way to any task that moves the vehicle: they are
/// aborted, and it is dispatched once they are over.
///
/// A command is executed once: its number, seen again from the same life of the ground station,
/// gets the same answer and nothing else.
///
/// Its components are executive, supervisor and interaction manager; who gets which request is a
/// table (src/routes.hpp), and what happens is told to all of them (src/component.hpp).
///
/// `now` never decreases. Deterministic. Not safe to share between threads.
/// Source: T II.2, T III, T IV.4, spec 1.2, 1.5, 6.2.
class DecisionNode {
 public:
  /// Precondition: what Config says of its fields.
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
