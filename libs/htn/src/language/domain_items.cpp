// SPDX-License-Identifier: Apache-2.0
// Operators, methods and axioms in the syntax of SHOP.
#include "language/condition_checker.hpp"
#include "language/domain_reader.hpp"
#include "language/effect_checker.hpp"
#include "language/task_checker.hpp"
#include "language/variable_counts.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::htn {

namespace {

bool is_number(Expression expression) {
  return !(*expression).list && (*expression).atom.is(TermKind::kNumber);
}

// SHOP3 takes nil for a label where all else looks like pairs of label and condition.
bool all_tails_labelled(const ReadContext& context, const std::vector<Expression>& all) {
  if (all.size() % 2 != 0) return false;
  for (std::size_t at = 2; at < all.size(); at += 2) {
    const bool label = context.is_nil(all[at]) || context.is_name(all[at]);
    if (!label || !(context.is_list(all[at + 1]) || context.is_nil(all[at + 1]))) return false;
  }
  return true;
}

}  // namespace

void read_keys(const ReadContext& context, const std::vector<Expression>& all, std::size_t at,
               const std::vector<std::pair<Term, Expression*>>& keys) {
  std::vector<std::string> names;
  for (const auto& [key, value] : keys) names.push_back(context.name(key));
  for (; at < all.size(); at += 2) {
    const Expression key = all[at];
    const std::string text = text_of(key);
    Expression* target = nullptr;
    for (const auto& [known, value] : keys) {
      if (context.is_symbol(key) && (*key).atom == known) target = value;
    }
    if (target == nullptr) {
      context.error(key, text + " where a keyword goes", names.front() + " or another",
                    nearest_name(text, names));
    } else if (at + 1 == all.size()) {
      context.error(key, "nothing behind " + text, "its value");
    } else if (*target) {
      context.error(key, text + " is given twice");
    } else {
      *target = all[at + 1];
    }
  }
}

bool DomainReader::check_head(Expression head, const char* what) const {
  const Expression name = first(head);
  if (name && context_.is_name(name)) return true;
  const std::string expected = "(name arguments…)";
  if (name && context_.is_variable(name)) {
    context_.error(name, "a variable for the name of " + std::string(what), expected);
  } else {
    context_.error(head, text_of(head) + " is no head of " + what, expected);
  }
  return false;
}

// Operators

void DomainReader::read_operator(Expression item) {
  const std::vector<Expression> all = parts(item);
  if (all.size() < 4 || all.size() > 6 || (*item).dotted) {
    return context_.error(item, "an operator of " + counted(all.size() - 1, "part"),
                          "(:operator (!name arguments…) precondition delete add [cost])");
  }
  OperatorDefinition made;
  made.head = all[1];
  const bool old_form = all.size() == 4 || (all.size() == 5 && is_number(all[4]));
  const std::size_t at = old_form ? 2 : 3;
  if (!old_form) made.precondition = all[2];
  made.deletions = all[at];
  made.additions = all[at + 1];
  if (at + 2 < all.size()) made.cost = all[at + 2];
  take_operator(item, made);
}

void DomainReader::read_op(Expression item) {
  const std::vector<Expression> all = parts(item);
  if (all.size() < 2 || (*item).dotted) {
    return context_.error(item, "an operator without a head",
                          "(:op (!name arguments…) :precond … :delete … :add … :cost …)");
  }
  const Words& words = context_.words;
  OperatorDefinition made;
  made.head = all[1];
  read_keys(context_, all, 2,
            {{words.precond, &made.precondition},
             {words.deletion, &made.deletions},
             {words.addition, &made.additions},
             {words.cost, &made.cost}});
  take_operator(item, made);
}

void DomainReader::take_operator(Expression item, const OperatorDefinition& made) {
  const std::size_t before = context_.errors.size();
  if (check_head(made.head, "an operator")) {
    const Expression name = first(made.head);
    if (!context_.name(name).starts_with('!')) {
      context_.error(name, "operator '" + context_.name(name) + "'", "a name that begins with '!'",
                     "!" + context_.name(name));
    } else if (!operator_names_.insert((*name).atom.bits()).second) {
      context_.error(name, "a second operator '" + context_.name(name) + "'",
                     "one operator of a name");
    }
  }
  ConditionChecker(context_).check_precondition(made.precondition);
  EffectChecker(context_).check_list(made.deletions);
  EffectChecker(context_).check_list(made.additions);
  if (context_.errors.size() != before) return;
  if (made.cost && !(*made.cost).list && (*made.cost).atom.is(TermKind::kString)) {
    context_.warn(made.cost, "a string for a cost; it counts as 1", "a number or an expression");
  }
  warn_operator_singletons(item, made);
  domain_.operators.push_back(made);
}

void DomainReader::warn_operator_singletons(Expression item, const OperatorDefinition& made) const {
  VariableCounts counts;
  counts.add(context_, item);
  warn_singletons(context_, counts, {}, "operator '" + context_.name(first(made.head)) + "'");
}

Term operator_name(const OperatorDefinition& made, TermStore& store) {
  const Expression symbol = made.action ? made.head : first(made.head);
  const std::string name(store.name((*symbol).atom));
  return name.starts_with('!') ? (*symbol).atom : store.symbol("!" + name);
}

// Methods

void DomainReader::read_method(Expression item, bool pddl) {
  const std::vector<Expression> all = parts(item);
  MethodDefinition made;
  made.pddl = pddl;
  domain_.pddl = domain_.pddl || pddl;
  std::size_t at = 1;
  if (at < all.size() && context_.is_name(all[at])) made.name = context_.name(all[at++]);
  if (at >= all.size() || (*item).dotted) {
    return context_.error(item, "a method without a head",
                          "(:method (name arguments…) [label] precondition tasks …)");
  }
  made.head = all[at++];
  if (!check_head(made.head, "a method")) return;
  const std::string task = context_.name(first(made.head));
  if (made.name.empty()) made.name = task;
  if (at == all.size())
    return context_.error(item, "a method without a branch", "precondition and tasks");
  while (at < all.size()) {
    BranchDefinition branch;
    branch.label = task + "-" + std::to_string(made.branches.size() + 1);
    const Expression begin = all[at];
    if (context_.is_name(begin)) branch.label = context_.name(all[at++]);
    if (at == all.size()) {
      return context_.error(begin, "nothing behind the label " + text_of(begin),
                            "precondition and tasks");
    }
    branch.precondition = all[at++];
    if (at == all.size()) {
      context_.warn(branch.precondition, "a branch without tasks; it is taken as nothing to do",
                    "tasks behind the precondition");
    } else {
      branch.tasks = unquoted(all[at++], context_.words);
    }
    made.branches.push_back(std::move(branch));
  }
  take_method(std::move(made));
}

void DomainReader::take_method(MethodDefinition made) {
  const std::size_t before = context_.errors.size();
  for (const BranchDefinition& branch : made.branches) {
    ConditionChecker(context_).check_precondition(branch.precondition);
    TaskChecker(context_).check(branch.tasks);
  }
  if (context_.errors.size() != before) return;
  const Expression name = first(made.head);
  if (context_.name(name).starts_with('!')) {
    context_.warn(name, "a method for '" + context_.name(name) + "' is never used",
                  "a name without '!'");
  }
  warn_method_singletons(made);
  domain_.methods.push_back(std::move(made));
}

void DomainReader::warn_method_singletons(const MethodDefinition& made) const {
  if (!context_.singletons) return;
  const std::string what = "method '" + context_.name(first(made.head)) + "'";
  VariableCounts head;
  head.add(context_, made.head);
  std::vector<VariableCounts> bodies(made.branches.size());
  std::vector<const VariableCounts*> others;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    bodies[i].add(context_, made.branches[i].precondition);
    bodies[i].add(context_, made.branches[i].tasks);
    const std::string branch =
        bodies.size() > 1 ? "branch " + std::to_string(i + 1) + " of " : std::string();
    warn_singletons(context_, bodies[i], {&head}, branch + what);
    others.push_back(&bodies[i]);
  }
  warn_singletons(context_, head, others, what);
}

// Axioms

void DomainReader::read_axiom(Expression item) {
  const std::vector<Expression> all = parts(item);
  if (all.size() < 2 || (*item).dotted) {
    return context_.error(item, "an axiom without a head",
                          "(:- (predicate arguments…) [label] condition …)");
  }
  AxiomDefinition made;
  made.head = all[1];
  if (!check_head(made.head, "an axiom")) return;
  const std::string predicate = context_.name(first(made.head));
  const bool labelled = all_tails_labelled(context_, all);
  for (std::size_t at = 2; at < all.size(); ++at) {
    BranchDefinition tail;
    tail.label = predicate + "-" + std::to_string(made.tails.size() + 1);
    const Expression begin = all[at];
    if (labelled || context_.is_name(begin)) {
      if (!context_.is_nil(begin)) tail.label = context_.name(begin);
      if (++at == all.size()) {
        return context_.error(begin, "nothing behind the label " + text_of(begin), "a condition");
      }
    }
    tail.precondition = all[at];
    made.tails.push_back(std::move(tail));
  }
  take_axiom(std::move(made));
}

void DomainReader::take_axiom(AxiomDefinition made) {
  const std::size_t before = context_.errors.size();
  const std::string what = "axiom '" + context_.name(first(made.head)) + "'";
  VariableCounts head;
  head.add(context_, made.head);
  std::vector<VariableCounts> bodies(made.tails.size());
  std::vector<const VariableCounts*> others;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    ConditionChecker(context_).check_precondition(made.tails[i].precondition);
    bodies[i].add(context_, made.tails[i].precondition);
    others.push_back(&bodies[i]);
  }
  if (context_.errors.size() != before) return;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::string tail =
        bodies.size() > 1 ? "tail " + std::to_string(i + 1) + " of " : std::string();
    warn_singletons(context_, bodies[i], {&head}, tail + what);
  }
  warn_singletons(context_, head, others, what);
  domain_.axioms.push_back(std::move(made));
}

}  // namespace skein::htn
