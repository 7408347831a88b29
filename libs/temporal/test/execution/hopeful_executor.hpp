// SPDX-License-Identifier: Apache-2.0
// A controller for networks that are not controllable: it hopes that nature will help.
#pragma once

#include <optional>
#include <vector>

#include "skein/temporal/network.hpp"

namespace skein::temporal::testing {

/// Plays one execution. The controller sees what has ended and supposes that the ends to come suit
/// it: before each decision it works out the dates that are still possible if nature obeyed, and
/// takes for each node the earliest or the latest. Every network that is consistent has dates to
/// take; what breaks it is a duration it did not hope for.
class HopefulExecutor {
 public:
  enum class Style { kEarliest, kLatest };

  HopefulExecutor(const Stnu& network, Style style) : network_(network), style_(style) {}

  /// True iff all nodes got dates that keep every requirement.
  bool survives(const std::vector<Ticks>& durations);

 private:
  struct Choice {
    NodeIndex node = 0;
    Ticks at = 0;
  };

  bool work_out();
  Ticks earliest(NodeIndex node) const;
  Ticks latest(NodeIndex node) const;
  bool is_end(NodeIndex node) const;
  std::optional<Choice> next_choice() const;
  std::optional<Choice> next_end(const std::vector<Ticks>& durations) const;

  const Stnu& network_;
  Style style_;
  Ticks now_ = 0;
  std::vector<std::optional<Ticks>> dates_;
  std::vector<std::vector<Ticks>> distance_;
};

}  // namespace skein::temporal::testing
