// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/functional_layer.hpp"

#include "skein/journal/lines/execution.hpp"
#include "skein/journal/lines/truth.hpp"
#include "skein/translation/sensing.hpp"

namespace skein::translation {

std::uint32_t truth_instance(const std::string& name) {
  std::uint32_t hash = 2166136261U;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return hash;
}

wire::Truth truth_of(const std::string& uav, const world::VehicleState& state) {
  wire::Truth sample;
  sample.header.instance = truth_instance(uav);
  sample.name = uav;
  sample.kind = "uav";
  sample.position = to_wire(state.position);
  sample.velocity = to_wire(state.velocity);
  sample.heading = state.heading;
  sample.energy = state.energy;
  sample.active = state.airborne;
  return sample;
}

journal::Record telemetry_line(MissionTime at, const std::string& node, const std::string& uav,
                               const world::VehicleState& state) {
  return journal::record_of(at, node,
                            journal::lines::Telemetry{.uav = uav,
                                                      .position = for_journal(state.position),
                                                      .velocity = for_journal(state.velocity),
                                                      .heading = journal::rounded(state.heading),
                                                      .energy = journal::rounded(state.energy),
                                                      .airborne = state.airborne});
}

void FunctionalLines::note(const std::string& uav, const functional::Request& asked) {
  if (asked.verb != functional::Verb::kDispatch) return;
  Asked task;
  task.type = asked.type;
  if (const auto* device = asked.parameters.find("device")) task.device = device->text;
  if (const auto* target = asked.parameters.find("target")) {
    task.target = journal::rounded(target->numbers);
  }
  asked_.try_emplace({uav, asked.id}, std::move(task));
}

std::optional<journal::Record> FunctionalLines::line_of(MissionTime at, const std::string& node,
                                                        const std::string& uav,
                                                        const functional::Status& status) {
  Asked& asked = asked_[{uav, status.id}];
  const std::string state(to_text(status.state));
  if (asked.told == state) return std::nullopt;
  asked.told = state;
  return journal::record_of(at, node,
                            journal::lines::Functional{.uav = uav,
                                                       .task = status.id.value(),
                                                       .type = asked.type,
                                                       .state = state,
                                                       .device = asked.device,
                                                       .target = asked.target,
                                                       .reason = status.reason});
}

}  // namespace skein::translation
