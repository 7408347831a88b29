// SPDX-License-Identifier: Apache-2.0
// Operator 4: has the interaction manager load joint tasks.
#pragma once

#include <map>
#include <string>

#include "book/outbox.hpp"

namespace skein::supervisor {

/// Joint tasks are loaded as soon as they are in the plan, since an agreement takes time. Lifetime:
/// refers to its arguments.
class JointTasks {
 public:
  JointTasks(Outbox& out, Book& book) : out_(out), book_(book) {}

  /// Asks to load joint tasks that are new in the plan, and again those that can no longer begin at
  /// the agreed time, or that which was asked for; gives up those that left the plan.
  void renew();
  /// Forgets all requests and answers, except of joint tasks that are due already.
  void begin_anew();
  /// Asks to load the joint task.
  void load(const Entry& entry);
  /// The executive wants a joint task carried out or interrupted; reports it aborted if it cannot
  /// be carried out.
  void due(const JointTaskDue& input);
  /// Takes an answer into the book. True when the agreed start differs from the planned one.
  bool answered(const JointTaskAnswered& input);

 private:
  struct Joint {
    bool answered = false, loaded = false, due = false;
    std::string why = {};
    MissionTime agreed = {};  ///< start, once loaded
    MissionTime asked = {};   ///< the earliest start that was asked for
    /// Whether the plan lets it begin no more when it was agreed, or asked for.
    bool is_overtaken_by(MissionTime earliest) const;
  };
  bool is_wanted(const Entry& entry) const;
  MissionTime now() const { return out_.now(); }
  void report(TaskId id, const std::string& why);

  Outbox& out_;
  Book& book_;
  std::map<TaskId, Joint> joints_;
};

}  // namespace skein::supervisor
