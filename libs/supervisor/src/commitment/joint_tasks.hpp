// SPDX-License-Identifier: Apache-2.0
// Operator 4: joint tasks are loaded with the interaction manager.
#pragma once

#include <map>
#include <string>

#include "book/outbox.hpp"

namespace skein::supervisor {

/// Joint tasks of the plan are loaded when they come into it, since an agreement takes its time.
/// Lifetime: refers to its arguments.
class JointTasks {
 public:
  JointTasks(Outbox& out, Book& book) : out_(out), book_(book) {}

  /// Asks for those that came into the plan, and for those that cannot begin any more when it was
  /// agreed; those that left it are not wanted any more.
  void renew();
  /// Nobody knows of what was asked for before.
  void begin_anew();
  /// Asks for it.
  void load(const Entry& entry);
  /// The executive wants it carried out, or interrupted: what cannot be is aborted.
  void due(const JointTaskDue& input);
  /// True when it is to start at another time than was planned, which is in the book now.
  bool answered(const JointTaskAnswered& input);

 private:
  struct Joint {
    bool answered = false, loaded = false, due = false;
    std::string why;
    MissionTime agreed;  ///< start, once loaded
  };
  bool is_wanted(const Entry& entry) const;
  MissionTime now() const { return out_.now(); }
  void report(TaskId id, const std::string& why);

  Outbox& out_;
  Book& book_;
  std::map<TaskId, Joint> joints_;
};

}  // namespace skein::supervisor
