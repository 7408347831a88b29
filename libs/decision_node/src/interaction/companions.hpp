// SPDX-License-Identifier: Apache-2.0
// Which partners of a joint task have ended, and which are lost to it.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "interaction/role_course.hpp"
#include "partners.hpp"

namespace skein::decision_node {

/// Once roles are agreed a holder of one is counted on until it says that it has ended. One that is
/// out of reach for kLostAfter, or declared lost, is lost. Source: spec 7.3.
class Companions {
 public:
  static constexpr Duration kLostAfter = Duration::milliseconds(60'000);

  /// Of `self`. References that must outlive it.
  Companions(const Partners& partners, const Membership& my, const std::string& self)
      : partners_(partners), my_(my), self_(self) {}

  /// Roles were agreed: what was said of the end of others counts no more.
  void begin_anew() { ended_.clear(); }
  void has_ended(const std::string& uav) { ended_.insert(uav); }
  /// Whether every other holder of a role has.
  bool all_have_ended() const;

  struct Lost {
    std::string uav, why;
  };
  /// Of those that are counted on.
  std::vector<Lost> lost(MissionTime now) const;
  /// When the next of them is lost, if it stays silent.
  std::optional<MissionTime> next_loss() const;
  /// When the next member is given up by who waits for it since then, if it stays silent.
  std::optional<MissionTime> next_given_up(MissionTime waits_since) const;

 private:
  std::vector<std::string> counted_on() const;

  const Partners& partners_;
  const Membership& my_;
  const std::string& self_;
  std::set<std::string> ended_;
};

}  // namespace skein::decision_node
