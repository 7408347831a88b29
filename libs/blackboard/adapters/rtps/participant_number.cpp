// SPDX-License-Identifier: Apache-2.0
// Which participant of its domain a program is on this machine.
#include "participant_number.hpp"

#include <string>
#include <utility>

#include "ports.hpp"

namespace skein::blackboard::rtps {

std::optional<ParticipantNumber> ParticipantNumber::claim(std::uint32_t domain) {
  for (std::uint32_t number = 0; number < kParticipants; ++number) {
    auto lock = NamedLock::take("skein-dds-participant-" + std::to_string(domain) + "-" +
                                std::to_string(number));
    if (!lock) continue;
    const auto ports = bound_udp_ports();
    const unsigned first = first_port(domain, number);
    if (ports.contains(first) || ports.contains(first + 1)) continue;
    return ParticipantNumber(number, std::move(*lock));
  }
  return std::nullopt;
}

}  // namespace skein::blackboard::rtps
