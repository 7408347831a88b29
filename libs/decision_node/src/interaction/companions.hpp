// SPDX-License-Identifier: Apache-2.0
// Which partners of a joint task have ended, and which are lost to it.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "interaction/role_course.hpp"
#include "partners.hpp"

namespace skein::decision_node {

/// Once roles are agreed a holder of one is counted on until it says that it has ended. One that is
/// declared lost, or out of reach for kLostAfter, is lost; out of reach for its lease, while
/// another holder that is in reach hears it and counts on it. Source: spec 7.3.
class Companions {
 public:
  static constexpr Duration kLostAfter = Duration::milliseconds(60'000);
  /// From when on it is told who is out of reach: before anybody asks.
  static constexpr Duration kToldAfter = Duration::milliseconds(30'000);

  /// Of `self`. References that must outlive it.
  Companions(const Partners& partners, const Membership& my, const std::string& self)
      : partners_(partners), my_(my), self_(self) {}

  /// Roles were agreed: what was said of the end of others counts no more.
  void begin_anew();
  /// Likewise of one of them.
  void begin_anew(const std::string& uav);
  void has_ended(const std::string& uav) { ended_.insert(uav); }
  /// A holder of a role said this of itself, and of whom it does not hear.
  void told(const interaction::JointTaskStatus& status);
  bool counts_on(const std::string& uav) const;
  /// Whether every holder of a role that is counted on has said that its role runs, or ran.
  bool all_have_begun() const;
  /// Whether one has, and goes on.
  bool some_have_begun() const;
  /// Those who are out of reach: a row `silent` for each, with its name.
  interaction::Rows silent(MissionTime now) const;
  /// Whether every other holder of a role has.
  bool all_have_ended() const;

  struct Lost {
    std::string uav, why;
  };
  /// Of those that are counted on.
  std::vector<Lost> lost(MissionTime now) const;
  /// When the next of them is told to be out of reach, or may be lost, if it stays silent.
  std::optional<MissionTime> next_loss(MissionTime now) const;
  /// When the next member is given up by who waits for it since then, if it stays silent.
  std::optional<MissionTime> next_given_up(MissionTime waits_since) const;

 private:
  std::vector<std::string> counted_on() const;
  bool is_silent_for(const std::string& uav, Duration time, MissionTime now) const;
  bool is_heard_by_another(const std::string& uav, MissionTime now) const;

  const Partners& partners_;
  const Membership& my_;
  const std::string& self_;
  std::set<std::string> ended_, begun_;
  /// Whom each other holder hears of those on whom it counts, as it said last.
  std::map<std::string, std::set<std::string>> hears_;
};

}  // namespace skein::decision_node
