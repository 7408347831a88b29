// SPDX-License-Identifier: Apache-2.0
// What a role negotiates in flight.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "interaction/area_share.hpp"
#include "interaction/asking_again.hpp"
#include "interaction/role_course.hpp"
#include "interaction/role_record.hpp"
#include "skein/negotiation/negotiation_manager.hpp"

namespace skein::decision_node {

inline constexpr const char* kAreaSharing = "area-sharing";

/// The coordination actions of a role that are under way: who plays what from now on, who maps
/// what, who goes where. Where nothing was agreed on areas or places it is asked again, for a
/// while.
class RoleTalks {
 public:
  /// What it shares with the rest of the role.
  struct Parts {
    RoleCourse& course;
    AreaShare& share;
    RoleRecord& record;
  };
  RoleTalks(const PlaySurroundings& of, const Parts& parts);

  /// Another role, or the same one once more: nothing is under way.
  void begin_anew();
  /// The role comes to the action.
  void negotiate(const std::string& action);
  /// The role goes on without it.
  void withdraw(const std::string& action);
  /// A session ended; true: the holders of roles are others now. Precondition: the outcome is known
  /// and the joint task runs.
  bool decided(const interaction::Terms& terms, const interaction::NegotiationOutcome& outcome);
  /// Somebody is lost: that roles were confirmed counts no more, and what is being shared is shared
  /// among those who are left.
  void lose();
  /// Asks again what is due.
  void time_passes();
  std::optional<MissionTime> next_wakeup() const;

 private:
  MissionTime now() const;
  /// The beginning of a session among the parties of an action, about nothing yet.
  interaction::BeginNegotiation session(const std::string& action, const std::string& modality,
                                        Duration within);
  /// The session that is about the subject was for this action; absent: for none any more.
  std::optional<std::string> action_about(const std::string& subject) const;
  void note(const std::string& text);

  void settle_anew(const std::string& action);
  void negotiate_roles(const std::string& action, const std::string& modality);
  bool roles_agreed(const interaction::Terms& terms,
                    const interaction::NegotiationOutcome& outcome);
  void share_area(const std::string& action);
  void area_shared(const interaction::Terms& terms, const interaction::NegotiationOutcome& outcome);
  /// Their parts have no owner.
  void lose_who_has_left(const interaction::Rows& parts);
  void negotiate_places(const std::string& action);
  void take_place_alone(const interaction::BeginNegotiation& begin);
  void places_agreed(const interaction::Terms& terms,
                     const interaction::NegotiationOutcome& outcome);
  void take_place(const std::string& action, const interaction::Terms& terms,
                  const interaction::Rows& result);

  JointHost& host_;
  Interaction& interaction_;
  JointTask& task_;
  Membership& my_;
  const std::string& self_;
  RoleCourse& course_;
  AreaShare& share_;
  RoleRecord& record_;

  std::map<std::string, std::string> actions_;  ///< under negotiation, to their subjects
  std::set<std::string> undecided_;  ///< subjects of which it is not known whether all agreed
  /// After the members agreed that all keep their roles, no new role negotiation before this.
  std::optional<MissionTime> roles_stand_until_;
  AskingAgain sharing_, places_;
};

}  // namespace skein::decision_node
