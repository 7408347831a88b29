// SPDX-License-Identifier: Apache-2.0
// Reads one (defdomain …), with the items of the files it includes.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "language/read_context.hpp"

namespace skein::htn {

class DomainReader {
 public:
  DomainReader(const ReadContext& context, Expression form) : context_(context), form_(form) {}
  void read();

 private:
  // domain_reader.cpp
  bool read_name(Expression name);
  void read_items(Expression items);
  void read_item(Expression item);
  bool read_declaration(Expression item, Term word);
  void read_static(Expression item);
  void read_include(Expression item);
  Result<std::string, Failure> included_text(std::string& name, bool computed) const;
  void read_included(Expression item, const std::string& name, const std::string& file);

  // domain_items.cpp
  void read_operator(Expression item);
  void read_op(Expression item);
  void take_operator(Expression item, const OperatorDefinition& made);
  void warn_operator_singletons(Expression item, const OperatorDefinition& made) const;
  void read_method(Expression item, bool pddl);
  void take_method(MethodDefinition made);
  void warn_method_singletons(const MethodDefinition& made) const;
  void read_axiom(Expression item);
  void take_axiom(AxiomDefinition made);
  bool check_head(Expression head, const char* what) const;

  // domain_pddl.cpp
  void read_action(Expression item);
  void check_action(const OperatorDefinition& made) const;
  void read_derived(Expression item);
  void read_types(Expression item);
  void check_types() const;
  void check_type(Expression type) const;
  void read_predicates(Expression item);
  void read_constants(Expression item);

  const ReadContext& context_;
  Expression form_;
  DomainDefinition domain_;
  std::vector<std::string> including_;  ///< files from the first that includes to the current
  std::size_t includes_ = 0;
  std::set<std::uint32_t> operator_names_;
  std::vector<Expression> used_types_;
};

/// The arguments of a plist (:key value …) from `at` on, each given to `take`, which says whether
/// it knows the key; unknown keys and keys without a value are errors.
void read_keys(const ReadContext& context, const std::vector<Expression>& all, std::size_t at,
               const std::vector<std::pair<Term, Expression*>>& keys);

/// The name an operator or action is called by: "!name".
Term operator_name(const OperatorDefinition& made, TermStore& store);

}  // namespace skein::htn
