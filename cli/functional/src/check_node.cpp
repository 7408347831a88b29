// SPDX-License-Identifier: Apache-2.0
#include "check_node.hpp"

#include <utility>

#include "skein/translation/sensing.hpp"
#include "skein/translation/tasks.hpp"

namespace skein::functional_tool {

using translation::from_wire;
using translation::to_wire;

CheckNode::CheckNode(Place place, const conformance::Config& config, Tell tell,
                     std::function<void()> call_for_restart)
    : place_(std::move(place)),
      check_(config),
      tell_(std::move(tell)),
      call_for_restart_(std::move(call_for_restart)) {}

node::Effects CheckNode::handle(const node::Input& input, MissionTime now) {
  node::Effects effects;
  const auto mine = input_of(input);
  if (!mine || check_.done()) return effects;
  for (const functional::Request& asked : check_.handle(*mine, now)) {
    effects.push_back(
        node::Send{place_.functional, to_wire(place_.uav, asked), MissionTime::max()});
  }
  for (; told_ < check_.verdicts().size(); ++told_) tell_(check_.verdicts()[told_]);
  if (check_.wants_restart() && call_for_restart_) std::exchange(call_for_restart_, {})();
  if (!check_.done()) return effects;
  wire::MissionState state;
  state.finished = true;
  state.outcome = "checked";
  effects.push_back(node::Publish{state});
  effects.push_back(node::Finish{});
  return effects;
}

std::optional<conformance::Input> CheckNode::input_of(const node::Input& input) const {
  if (std::holds_alternative<node::Wakeup>(input) || std::holds_alternative<node::Started>(input)) {
    return conformance::Tick{};
  }
  const auto* reach = std::get_if<node::Reachability>(&input);
  if (reach != nullptr && reach->peer == place_.functional && reach->restarted)
    return conformance::Restarted{};
  const auto* received = std::get_if<node::Received>(&input);
  if (received == nullptr || received->from != place_.functional) return std::nullopt;
  if (const auto* status = std::get_if<wire::FunctionalStatus>(&received->sample)) {
    return from_wire(*status);
  }
  if (const auto* telemetry = std::get_if<wire::Telemetry>(&received->sample)) {
    return from_wire(*telemetry);
  }
  if (const auto* look = std::get_if<wire::PerceptionReport>(&received->sample)) {
    return from_wire(*look);
  }
  return std::nullopt;
}

}  // namespace skein::functional_tool
