// SPDX-License-Identifier: Apache-2.0
#include "traffic.hpp"

namespace skein::spy_tool {

namespace {

/// [s] Histories come in a burst when a reader joins; what came in less time has no rate.
constexpr double kLeastSpan = 0.5;

}  // namespace

double Flow::rate() const {
  const double seconds = (last - first).to_seconds();
  if (samples + malformed < 2 || seconds < kLeastSpan) return 0;
  return static_cast<double>(samples + malformed - 1) / seconds;
}

void Traffic::count(wire::Slot slot, std::uint32_t origin, std::uint32_t destination,
                    bool malformed, Duration at) {
  Flow& flow = flows_[{slot, origin, destination}];
  if (flow.samples + flow.malformed == 0) {
    flow.slot = slot;
    flow.origin = origin;
    flow.destination = destination;
    flow.first = at;
  }
  ++(malformed ? flow.malformed : flow.samples);
  flow.last = at;
}

std::vector<Flow> Traffic::flows() const {
  std::vector<Flow> flows;
  for (const auto& [key, flow] : flows_) flows.push_back(flow);
  return flows;
}

}  // namespace skein::spy_tool
