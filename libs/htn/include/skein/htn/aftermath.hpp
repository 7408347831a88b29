// SPDX-License-Identifier: Apache-2.0
// The state of the world after what a problem says has happened.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "skein/htn/planner.hpp"

namespace skein::htn {

/// The facts of a problem with its past on top of them (Problem::past): steps are applied as the
/// search would, changes are made as they are said. It ends early before the first step that does
/// not apply. Cost: that of the steps' preconditions. Domain and store must outlive it.
class Aftermath {
 public:
  Aftermath(const Domain& domain, const Problem& problem, const Limits& limits,
            const Host& host = {});
  ~Aftermath();
  Aftermath(const Aftermath&) = delete;
  Aftermath& operator=(const Aftermath&) = delete;

  /// Events up to the first step that does not apply; all of them otherwise.
  std::size_t events() const { return events_; }
  /// A limit cut it; why() says which.
  bool cut() const { return cut_; }
  /// A term could not be evaluated; why() says which.
  bool failed() const { return failed_; }
  const std::string& why() const { return why_; }

  /// Whether a ground atom is among the facts then.
  bool holds(Term fact) const;
  /// All facts then, in no order that means anything.
  std::vector<Term> facts() const;

 private:
  class State;
  std::unique_ptr<State> state_;
  std::size_t events_ = 0;
  bool cut_ = false;
  bool failed_ = false;
  std::string why_;
};

}  // namespace skein::htn
