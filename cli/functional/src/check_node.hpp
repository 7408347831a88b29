// SPDX-License-Identifier: Apache-2.0
// The check as a node in the place of a UAV's decision node.
#pragma once

#include <functional>
#include <vector>

#include "skein/conformance/conformance.hpp"
#include "skein/node/node.hpp"

namespace skein::functional_tool {

/// Ends the mission once every point is decided.
class CheckNode final : public node::Node {
 public:
  struct Place {
    std::string uav;
    node::NodeNumber functional;  ///< its functional layer
  };
  /// Tells each verdict as it is reached.
  using Tell = std::function<void(const conformance::Verdict&)>;

  /// `call_for_restart` once, when the layer is to be killed and started again.
  CheckNode(Place place, const conformance::Config& config, Tell tell,
            std::function<void()> call_for_restart);

  node::Effects handle(const node::Input& input, MissionTime now) override;
  std::optional<MissionTime> next_wakeup() const override { return check_.next_wakeup(); }

 private:
  std::optional<conformance::Input> input_of(const node::Input& input) const;

  Place place_;
  conformance::Conformance check_;
  Tell tell_;
  std::function<void()> call_for_restart_;  ///< empty once called
  std::size_t told_ = 0;
};

}  // namespace skein::functional_tool
