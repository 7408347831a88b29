// SPDX-License-Identifier: Apache-2.0
#include "commands.hpp"

#include <array>

#include "mav.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::autopilot {

namespace {

constexpr Duration kAnswerWithin = Duration::milliseconds(500);
constexpr Duration kBusyFor = Duration::milliseconds(1000);
constexpr Duration kProgressWithin = Duration::milliseconds(10'000);
constexpr int kTries = 5;

std::string name_of_result(std::uint8_t result) {
  constexpr std::array kNames = {"accepted", "temporarily rejected", "denied",   "unsupported",
                                 "failed",   "in progress",          "cancelled"};
  if (result < kNames.size()) return kNames[result];
  return "result " + std::to_string(result);
}

std::pair<std::uint8_t, std::uint16_t> key_of(const Command& command) {
  return std::visit([](const auto& one) { return std::pair(one.target_component, one.command); },
                    command);
}

/// Of these the last one counts: one before it is not sent again.
bool replaces(std::uint16_t command) {
  return command == mav::kDoReposition || command == mav::kDoSetMode;
}

}  // namespace

std::string name_of_command(std::uint16_t command) {
  static const std::map<std::uint16_t, std::string> names = {
      {mav::kNavTakeoff, "NAV_TAKEOFF"},
      {mav::kDoSetMode, "DO_SET_MODE"},
      {mav::kDoChangeSpeed, "DO_CHANGE_SPEED"},
      {mav::kDoReposition, "DO_REPOSITION"},
      {mav::kDoDigicamControl, "DO_DIGICAM_CONTROL"},
      {mav::kComponentArmDisarm, "COMPONENT_ARM_DISARM"},
      {mav::kSetMessageInterval, "SET_MESSAGE_INTERVAL"},
      {mav::kImageStartCapture, "IMAGE_START_CAPTURE"}};
  const auto found = names.find(command);
  return found == names.end() ? "command " + std::to_string(command) : found->second;
}

Commands::Ticket Commands::ask(Command command, Duration now, Outbox& out) {
  const Ticket ticket = next_++;
  Queue& queue = waiting_[key_of(command)];
  queue.push_back({ticket, std::move(command)});
  if (queue.size() == 1) send(queue.front(), now, out);
  return ticket;
}

std::vector<Commands::Outcome> Commands::hear(const mavlink::CommandAck& ack, mavlink::Address from,
                                              Duration now, Outbox& out) {
  const bool for_another = ack.target_system != 0 && ack.target_system != own_.system;
  const auto found = waiting_.find({from.component, ack.command});
  if (for_another || found == waiting_.end()) return {};
  Asked& asked = found->second.front();
  if (ack.result == mav::kInProgress) {
    asked.again_at = now + kProgressWithin;
    return {};
  }
  if (ack.result == mav::kTemporarilyRejected && asked.sent < kTries) {
    asked.again_at = now + kBusyFor;
    return {};
  }
  Outcome outcome{asked.ticket, ack.result == mav::kAccepted};
  if (!outcome.accepted) {
    outcome.why = "the autopilot answered " + name_of_command(ack.command) + " by '" +
                  name_of_result(ack.result) + "'";
  }
  advance(found->second, now, out);
  if (found->second.empty()) waiting_.erase(found);
  return {outcome};
}

std::vector<Commands::Outcome> Commands::step(Duration now, Outbox& out) {
  std::vector<Outcome> outcomes;
  for (auto it = waiting_.begin(); it != waiting_.end();) {
    Asked& asked = it->second.front();
    const bool is_replaced = it->second.size() > 1 && replaces(it->first.second);
    if (now >= asked.again_at && asked.sent < kTries && !is_replaced) {
      send(asked, now, out);
    } else if (now >= asked.again_at) {
      outcomes.push_back({asked.ticket, false,
                          "the autopilot did not answer " + name_of_command(it->first.second)});
      advance(it->second, now, out);
    }
    it = it->second.empty() ? waiting_.erase(it) : std::next(it);
  }
  return outcomes;
}

void Commands::drop() {
  std::erase_if(waiting_,
                [](const auto& one) { return one.first.second != mav::kSetMessageInterval; });
}

void Commands::advance(Queue& queue, Duration now, Outbox& out) {
  queue.pop_front();
  if (!queue.empty()) send(queue.front(), now, out);
}

void Commands::send(Asked& asked, Duration now, Outbox& out) {
  std::visit(Overloaded{[&](mavlink::CommandLong& command) {
                          command.confirmation = static_cast<std::uint8_t>(asked.sent);
                          out.send(command);
                        },
                        [&](const mavlink::CommandInt& command) { out.send(command); }},
             asked.command);
  ++asked.sent;
  asked.again_at = now + kAnswerWithin;
}

}  // namespace skein::autopilot
