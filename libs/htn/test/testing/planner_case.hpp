// SPDX-License-Identifier: Apache-2.0
// A domain and a problem as text, compiled when first used, and what planning makes of them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "skein/htn/planner.hpp"

namespace skein::htn::test {

/// Options, functions and listeners are set before the first question.
class Case {
 public:
  /// The items of a domain; the atoms of the initial state; the tasks.
  explicit Case(const std::string& items, const std::string& facts = "",
                const std::string& tasks = "()");
  Case(const Case&) = delete;
  Case& operator=(const Case&) = delete;

  TermStore store;
  Functions functions;
  Options options;
  Host host;

  Domain& domain();
  const Problem& problem();
  /// Errors of reading and compiling; empty when the domain is sound.
  std::string errors();
  Outcome run();

  /// The steps of the first plan "(!a 1) (!b)"; "no plan"; "limit: …"; "error: …".
  std::string first();
  /// The steps of every plan.
  std::vector<std::string> all();
  std::string steps(const Plan& plan) const;
  /// A term written as text; variables are not known here.
  Term term(const std::string& text);

 private:
  void compile();
  std::string shown(const Outcome& outcome) const;

  std::string text_;
  bool compiled_ = false;
  Definitions definitions_;
  Diagnostics errors_;
  std::shared_ptr<Domain> domain_;
  Problem problem_;
};

/// A method without condition that does `tasks`.
std::string does(const std::string& head, const std::string& tasks);
/// An operator without condition that adds `added`.
std::string adds(const std::string& head, const std::string& added, const std::string& cost = "1");

}  // namespace skein::htn::test
