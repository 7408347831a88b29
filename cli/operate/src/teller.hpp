// SPDX-License-Identifier: Apache-2.0
// Prints the progress of commands for people.
#pragma once

#include <iosfwd>
#include <set>
#include <utility>

#include "skein/blackboard/wire.hpp"

namespace skein::operate_tool {

/// Prints each state of each command once, in order, including states that a reply skips because
/// the command has passed them. Accepted actions without commands are reported as done.
class Teller {
 public:
  /// `out` must outlive it.
  explicit Teller(std::ostream& out) : out_(out) {}
  void tell(const wire::OperatorReply& reply);

 private:
  void tell(const wire::CommandEntry& command, wire::CommandState state);

  std::ostream& out_;
  std::set<std::pair<std::uint64_t, wire::CommandState>> told_;
  bool done_ = false;
};

}  // namespace skein::operate_tool
