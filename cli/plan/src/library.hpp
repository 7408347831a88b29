// SPDX-License-Identifier: Apache-2.0
// Everything that the files of one command define, and the domain of each problem.
#pragma once

#include <iosfwd>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/htn/definitions.hpp"
#include "skein/htn/domain.hpp"
#include "skein/htn/wanted_problems.hpp"

namespace skein::plan_tool {

/// A problem and the domain it is planned with.
struct ChosenProblem {
  const htn::ProblemDefinition* problem = nullptr;
  const htn::DomainDefinition* domain = nullptr;
};

/// Files are read once, in order; what comes later replaces domains of the same name, as in Lisp.
class Library {
 public:
  /// What is suspicious in the files is looked for only if `wary`. If not, and if `problems` names
  /// any, other problems are passed over; their facts count for what is suspicious in a domain.
  explicit Library(bool wary, std::vector<std::string> problems = {}) : wary_(wary) {
    if (!wary) wanted_.names = std::move(problems);
  }

  /// Everything wrong goes to `errors`, everything suspicious to `warnings`.
  void read(const std::vector<std::string>& files, std::istream& in);
  /// The problems named, or all, in the order of the text. A problem whose domain was not read
  /// takes the only domain there is. What cannot be found goes to `errors`.
  std::vector<ChosenProblem> choose(const std::vector<std::string>& names);
  /// The domains of these problems; if there are errors already, all domains, so that everything
  /// wrong is told at once.
  void compile(const std::vector<ChosenProblem>& problems);
  /// Names (of --trace) that no domain has a method or an operator for go to `warnings`.
  void check_tasks(const std::vector<std::string>& names);
  /// Null, with the reasons in `errors`, if it cannot be compiled.
  const htn::Domain* compiled(const htn::DomainDefinition& domain);

  const Diagnostics& errors() const { return errors_; }
  const Diagnostics& warnings() const { return warnings_; }
  const htn::Definitions& definitions() const { return definitions_; }
  htn::Definitions& definitions() { return definitions_; }
  const htn::Functions& functions() const { return functions_; }
  /// To fill before anything is compiled.
  htn::Functions& functions() { return functions_; }
  /// Adds errors of other files of the command.
  void blame(const Diagnostics& errors) { errors_.append(errors); }
  htn::TermStore& store() { return store_; }

 private:
  void read_file(const std::string& file, std::istream& in);
  std::string folded(const std::string& name);
  const htn::DomainDefinition* domain_of(const htn::ProblemDefinition& problem);
  void report_foreign();
  void report_unknown(const std::vector<std::string>& names);

  bool wary_;
  htn::WantedProblems wanted_;
  htn::TermStore store_;
  htn::Functions functions_;
  htn::Definitions definitions_;
  Diagnostics errors_;
  Diagnostics warnings_;
  std::map<const htn::DomainDefinition*, std::shared_ptr<htn::Domain>> compiled_;
};

}  // namespace skein::plan_tool
