// SPDX-License-Identifier: Apache-2.0
// Members that ask for a joint task that runs without them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "interaction/companions.hpp"
#include "interaction/joint_play.hpp"
#include "interaction/role_course.hpp"
#include "skein/negotiation/negotiation_manager.hpp"

namespace skein::decision_node {

/// On a UAV that plays a role. A member that holds none asks for roles, and then for a start, as
/// for a joint task that is to begin: those who play keep their roles, and begin with it at once.
/// It is taken in where roles share an area, or agree on places, anew when they are called to, and
/// none of these is through with that; else it is told why it is not.
class Newcomers {
 public:
  /// References that must outlive it.
  /// `asked`: with all members that were asked.
  Newcomers(const PlaySurroundings& of, const Joint& asked, JointPlay& play,
            Companions& companions);

  /// Whether a session is about the role, or the start, of such a member.
  bool come_by(const interaction::Terms& terms) const;
  // Precondition of invited(), offer_for() and decided(): they come by it.
  /// Somebody opened the session.
  void invited(const interaction::Terms& terms);
  /// Somebody opened a session that the roles negotiate in flight; true: it is one who is awaited,
  /// and heard once it is taken in.
  bool called(const interaction::Terms& terms);
  Result<interaction::Rows, Failure> offer_for(const interaction::Terms& terms) const;
  void decided(const interaction::Terms& terms, const interaction::NegotiationOutcome& outcome);
  /// Roles of those who are awaited: agreed on, without a start.
  Holders awaited() const;
  /// Whether what that member said then is about the time before it was taken in.
  bool is_from_before(const std::string& uav, MissionTime at) const;

 private:
  struct Agreed {
    std::string role, allocation;
    MissionTime at;
    std::optional<std::string> call = {};  ///< message to the role that waits until it is taken in
  };
  /// Members of a session that hold no role.
  std::vector<std::string> in(const interaction::Terms& terms) const;
  /// Whether the role that is played does not stand against it.
  bool are_taken_in() const;
  /// The joint task among those who play and these; absent: they would be in another variant.
  std::optional<Joint> with(const std::vector<std::string>& newcomers) const;
  void take_in(const std::string& uav, const Agreed& agreed);

  JointHost& host_;
  Interaction& interaction_;
  JointTask& task_;
  Membership& my_;
  const Joint& asked_;
  const std::string& self_;
  JointPlay& play_;
  Companions& companions_;
  std::map<std::string, Agreed> agreed_;         ///< roles of those whose start is not agreed on
  std::map<std::string, MissionTime> taken_in_;  ///< and when
};

}  // namespace skein::decision_node
