// SPDX-License-Identifier: Apache-2.0
#include "listener.hpp"

#include "mav.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::autopilot {

std::vector<Answer> Listener::take(const mavlink::Bytes& bytes, Duration now, Outbox& out) {
  std::vector<Answer> answers;
  for (const mavlink::Frame& frame : parser_.take(bytes)) {
    const auto message = mavlink::to_message(frame);
    if (!message || !recognises(frame, *message, out)) continue;
    if (const auto* ack = std::get_if<mavlink::CommandAck>(&*message)) {
      answers.emplace_back(*ack, frame.from);
    } else if (frame.from.component == mav::kAutopilotComponent) {
      note(*message, now, out);
    }
  }
  return answers;
}

bool Listener::recognises(const mavlink::Frame& frame, const mavlink::Message& message,
                          Outbox& out) {
  const std::uint8_t from = frame.from.system;
  if (system_) {
    const bool is_other = from != *system_ && frame.from.component == mav::kAutopilotComponent &&
                          std::holds_alternative<mavlink::Heartbeat>(message) && !config_.system;
    if (is_other && strangers_.insert(from).second) {
      out.say("system " + std::to_string(from) + " is on the link too: --system-id chooses");
    }
    return from == *system_;
  }
  const auto* heartbeat = std::get_if<mavlink::Heartbeat>(&message);
  const bool flies = heartbeat != nullptr && frame.from.component == mav::kAutopilotComponent &&
                     heartbeat->autopilot != mav::kNoAutopilot &&
                     heartbeat->type != mav::kTypeGroundStation;
  if (!flies || (config_.system && from != *config_.system)) return false;
  system_ = from;
  return true;
}

void Listener::note(const mavlink::Message& message, Duration now, Outbox& out) {
  std::visit(Overloaded{[&](const mavlink::Heartbeat& one) { picture_.hear(one, now); },
                        [&](const mavlink::GlobalPositionInt& one) { picture_.hear(one, now); },
                        [&](const mavlink::Attitude& one) { picture_.hear(one); },
                        [&](const mavlink::ExtendedSysState& one) { picture_.hear(one); },
                        [&](const mavlink::SysStatus& one) {
                          picture_.hear_battery(one.battery_remaining);
                        },
                        [&](const mavlink::BatteryStatus& one) {
                          if (one.id == 0) picture_.hear_battery(one.battery_remaining);
                        },
                        [&](const mavlink::StatusText& one) {
                          if (one.severity <= mav::kSeverityWarning)
                            out.say("the autopilot says: " + mavlink::text_of(one));
                        },
                        [](const auto&) {}},
             message);
}

}  // namespace skein::autopilot
