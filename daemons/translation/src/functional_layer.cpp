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
  Asked& task = entry({uav, asked.id});
  if (!task.type.empty()) return;
  task.type = asked.type;
  if (const auto* device = asked.parameters.find("device")) task.device = device->text;
  if (const auto* target = asked.parameters.find("target")) {
    task.target = journal::rounded(target->numbers);
  }
}

std::optional<journal::Record> FunctionalLines::line_of(MissionTime at, const std::string& node,
                                                        const std::string& uav,
                                                        const functional::Status& status) {
  const Key key{uav, status.id};
  Asked& asked = entry(key);
  if (asked.told == status.state) return std::nullopt;
  const bool was_over = asked.told && functional::is_terminal(*asked.told);
  asked.told = status.state;
  auto line =
      journal::record_of(at, node,
                         journal::lines::Functional{.uav = uav,
                                                    .task = status.id.value(),
                                                    .type = asked.type,
                                                    .state = std::string(to_text(status.state)),
                                                    .device = asked.device,
                                                    .target = asked.target,
                                                    .reason = status.reason});
  if (!was_over && functional::is_terminal(status.state)) file(key);
  return line;
}

/// What was let go comes back with its state, and so is not told again.
FunctionalLines::Asked& FunctionalLines::entry(const Key& key) {
  const auto [at, is_new] = asked_.try_emplace(key);
  if (const std::uint8_t past = is_new ? past_[key.first].of(key.second.value()) : 0; past != 0) {
    at->second.told = static_cast<functional::TaskState>(past - 1);
    if (functional::is_terminal(*at->second.told)) file(key);
  }
  return at->second;
}

/// It is over: the oldest that is goes, if there are too many.
void FunctionalLines::file(const Key& key) {
  over_.push_back(key);
  if (over_.size() <= kKept) return;
  const auto oldest = asked_.find(over_.front());
  over_.pop_front();
  const bool is_over = oldest != asked_.end() && functional::is_terminal(*oldest->second.told);
  if (!is_over) return;  // it came again meanwhile
  past_[oldest->first.first].set(oldest->first.second.value(),
                                 1 + static_cast<std::uint8_t>(*oldest->second.told));
  asked_.erase(oldest);
}

}  // namespace skein::translation
