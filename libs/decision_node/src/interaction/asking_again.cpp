// SPDX-License-Identifier: Apache-2.0
#include "interaction/asking_again.hpp"

#include "skein/foundation/contract.hpp"

namespace skein::decision_node {

void AskingAgain::ask(const std::string& action, MissionTime now) {
  if (!open_) open_ = Open{action, {}, now + patience_};
  open_->action = action;
  open_->at.reset();
}

void AskingAgain::not_agreed(const std::string& why, MissionTime now) {
  if (!open_) return;
  open_->at = now + kPause;
  open_->why = why;
}

void AskingAgain::renew(MissionTime now) {
  if (open_) open_->until = now + patience_;
}

void AskingAgain::stop(const std::string& action) {
  if (asks(action)) stop();
}

bool AskingAgain::lasts(MissionTime then) const {
  SKEIN_EXPECTS(open_.has_value());
  return then < open_->until;
}

std::optional<std::string> AskingAgain::due(MissionTime now) const {
  const auto at = next();
  return at && *at <= now ? std::optional(open_->action) : std::nullopt;
}

}  // namespace skein::decision_node
