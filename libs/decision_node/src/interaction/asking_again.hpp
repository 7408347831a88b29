// SPDX-License-Identifier: Apache-2.0
// What is negotiated again since nothing was agreed.
#pragma once

#include <optional>
#include <string>

#include "skein/foundation/time.hpp"

namespace skein::decision_node {

/// Of one kind of coordination actions the one that is under negotiation, for as long as it is
/// worth it. A value.
class AskingAgain {
 public:
  static constexpr Duration kPause = Duration::milliseconds(1'000);  ///< from a failure on

  explicit AskingAgain(Duration patience) : patience_(patience) {}

  /// The action is negotiated now: for the first time, or on behalf of what was before.
  void ask(const std::string& action, MissionTime now);
  /// To be asked again after a pause. No effect if nothing is asked.
  void not_agreed(const std::string& why, MissionTime now);
  /// The circumstances are others: from now on for as long as at first. No effect if nothing is
  /// asked.
  void renew(MissionTime now);
  void stop() { open_.reset(); }
  /// The same, if it is this action.
  void stop(const std::string& action);

  bool asks(const std::string& action) const { return open_ && open_->action == action; }
  /// Whether the patience lasts longer than until then. Precondition: something is asked.
  bool lasts(MissionTime then) const;
  /// Why nothing was agreed the last time; empty: it was not asked before.
  std::string why() const { return open_ ? open_->why : ""; }
  /// The action that is to be asked again by now.
  std::optional<std::string> due(MissionTime now) const;
  std::optional<MissionTime> next() const { return open_ ? open_->at : std::nullopt; }

 private:
  struct Open {
    std::string action;
    std::optional<MissionTime> at;  ///< absent: under negotiation
    MissionTime until;
    std::string why = {};
  };
  Duration patience_;
  std::optional<Open> open_;
};

}  // namespace skein::decision_node
