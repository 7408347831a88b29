// SPDX-License-Identifier: Apache-2.0
// Names of states, as the journal, the wire and people have them.
#include "skein/ground_orders/alarm.hpp"
#include "skein/ground_orders/messages.hpp"

namespace skein::ground_station {

std::string_view to_text(AlarmState state) {
  switch (state) {
    case AlarmState::kRaised:
      return "raised";
    case AlarmState::kConfirmed:
      return "confirmed";
    case AlarmState::kInfirmed:
      break;
  }
  return "infirmed";
}

std::string_view to_text(CommandState state) {
  switch (state) {
    case CommandState::kIssued:
      return "issued";
    case CommandState::kDelivered:
      return "delivered";
    case CommandState::kAcknowledged:
      return "acknowledged";
    case CommandState::kRefused:
      return "refused";
    case CommandState::kExpired:
      break;
  }
  return "expired";
}

std::string_view to_text(GlobalStage stage) {
  switch (stage) {
    case GlobalStage::kRefused:
      return "refused";
    case GlobalStage::kGiven:
      return "given";
    case GlobalStage::kDone:
      break;
  }
  return "done";
}

std::string_view to_text(HeldState state) {
  switch (state) {
    case HeldState::kHeld:
      return "held";
    case HeldState::kResumed:
      return "resumed";
    case HeldState::kDropped:
      break;
  }
  return "dropped";
}

}  // namespace skein::ground_station
