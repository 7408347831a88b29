// SPDX-License-Identifier: Apache-2.0
// What the decision node has worked out in jobs.
#pragma once

#include <memory>
#include <optional>

#include "skein/decision_node/decision_node.hpp"
#include "skein/node/node.hpp"
#include "skein/supervisor/deliberator.hpp"

namespace skein::ddn {

/// Makes jobs of the runtime from what the decision node asks for, and inputs of their results.
/// Each kind of job has numbers of its own.
class Jobs {
 public:
  /// `deliberation`: time limit of one plan, with a real clock.
  explicit Jobs(Duration deliberation) : deliberation_(deliberation) {}

  node::StartJob effect_of(const decision_node::StartReckoning& asked) const;
  node::StopJob effect_of(const decision_node::StopReckoning& asked) const;
  node::StartJob effect_of(const decision_node::StartDetours& asked) const;
  node::StartJob effect_of(const decision_node::StartWaySearch& asked) const;
  node::StartJob effect_of(const supervisor::StartDeliberation& asked) const;
  node::StopJob effect_of(const supervisor::StopDeliberation& asked) const;
  /// Nothing: the result is of no kind that is known here.
  static std::optional<decision_node::Input> input_of(const node::JobDone& done);

 private:
  Duration deliberation_;
  /// Works in jobs, one after another; here it is only handed on.
  std::shared_ptr<supervisor::Deliberator> deliberator_ =
      std::make_shared<supervisor::Deliberator>();
};

}  // namespace skein::ddn
