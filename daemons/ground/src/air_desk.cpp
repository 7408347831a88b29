// SPDX-License-Identifier: Apache-2.0
#include "skein/ground/air_desk.hpp"

#include "skein/translation/merging.hpp"

namespace skein::ground {

AirDesk::AirDesk(const node::Roster& roster, const std::vector<std::string>& members)
    : roster_(roster), witness_(members) {}

// What makes no sense is as if it had not come.
std::optional<node::Effects> AirDesk::hear(const node::Input& input, MissionTime now) {
  if (const auto* started = std::get_if<node::Started>(&input)) {
    witness_.begin(started->first_life, now);
    return std::nullopt;
  }
  const auto* received = std::get_if<node::Received>(&input);
  if (received == nullptr) return std::nullopt;
  const auto* told = std::get_if<wire::MergeMessage>(&received->sample);
  if (told == nullptr) return std::nullopt;
  node::Effects effects;
  const auto message = translation::from_wire(*told);
  if (!message) return effects;
  for (const auto& answer : witness_.hear(roster_.name_of(received->from), *message, now))
    effects.push_back(
        node::Send{roster_.find(answer.to)->number, translation::to_wire(answer.message)});
  return effects;
}

}  // namespace skein::ground
