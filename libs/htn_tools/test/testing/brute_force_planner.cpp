// SPDX-License-Identifier: Apache-2.0
#include "testing/brute_force_planner.hpp"

#include <algorithm>

#include "testing/brute_force_prover.hpp"

namespace skein::htn::oracle {

namespace {

using replay::Effect;
using replay::EffectKind;
using replay::MethodClause;
using replay::NetworkClause;
using replay::OperatorClause;

/// A task network as a value.
struct Net {
  TreeNodeKind kind = TreeNodeKind::kOrdered;
  std::vector<Net> children;
  Term task;
  bool immediate = false;
  int id = 0;  // of a task, unique in a search

  bool same(const Net& other) const {
    return kind == other.kind && task == other.task && immediate == other.immediate &&
           std::equal(children.begin(), children.end(), other.children.begin(),
                      other.children.end(), [](const Net& a, const Net& b) { return a.same(b); });
  }
};

bool already_immediate(const Net& net) {
  if (net.kind == TreeNodeKind::kTask) return net.immediate;
  if (net.kind == TreeNodeKind::kOrdered) return already_immediate(net.children.front());
  return std::any_of(net.children.begin(), net.children.end(), already_immediate);
}

// One copy for each task that may come first.
std::vector<Net> with_immediate(const Net& net) {
  if (already_immediate(net)) return {net};
  if (net.kind == TreeNodeKind::kTask) {
    Net copy = net;
    copy.immediate = true;
    return {copy};
  }
  std::vector<Net> out;
  const std::size_t choices = net.kind == TreeNodeKind::kOrdered ? 1 : net.children.size();
  for (std::size_t at = 0; at < choices; ++at) {
    for (Net& child : with_immediate(net.children[at])) {
      out.push_back(net);
      out.back().children[at] = std::move(child);
    }
  }
  return out;
}

void first_tasks(const Net& net, std::vector<Net>& out) {
  if (net.kind == TreeNodeKind::kTask) out.push_back(net);
  for (const Net& child : net.children) {
    first_tasks(child, out);
    if (net.kind == TreeNodeKind::kOrdered) break;
  }
}

bool replace(Net& net, int id, const Net& by) {
  if (net.kind == TreeNodeKind::kTask) {
    if (net.id == id) net = by;
    return net.id == id;
  }
  return std::any_of(net.children.begin(), net.children.end(),
                     [&](Net& child) { return replace(child, id, by); });
}

// Networks that become empty go too.
void remove(Net& net, int id) {
  std::erase_if(net.children, [&](Net& child) {
    if (child.kind == TreeNodeKind::kTask) return child.id == id;
    remove(child, id);
    return child.children.empty();
  });
}

class Search {
 public:
  Search(TermStore& store, const replay::Clauses& clauses, Lisp& lisp, const OracleLimits& limits)
      : store_(store),
        facts_(store),
        clauses_(clauses),
        limits_(limits),
        prover_(store, clauses, lisp, facts_, limits.inferences) {}

  OracleOutcome run(const ProblemDefinition& problem, const NetworkClause& tasks,
                    std::uint32_t slots) {
    std::vector<Facts::Change> changes;
    for (const NodeIndex fact : children(*problem.facts.document, problem.facts.node)) {
      facts_.add(replay::term_of({problem.facts.document, fact}, store_), changes);
    }
    try {
      Node root{Substitution(store_), {}, {}, {}, {}};
      root.net = network(tasks, prover_.fresh(slots), root.known);
      number_tasks(root.net);
      if (root.net.kind == TreeNodeKind::kTask)
        root.net = {TreeNodeKind::kOrdered, {root.net}, {}, false, 0};
      first_tasks(root.net, root.agenda);
      seek(root);
    } catch (const Stop& stop) {
      if (stop.kind == Stop::Kind::kError) out_.error = stop.what();
      out_.out_of_budget = stop.kind == Stop::Kind::kBudget;
    }
    out_.inferences = prover_.inferences();
    return out_;
  }

 private:
  struct Protection {
    Term goal;
    int count;
  };
  struct Node {
    Substitution known;
    Net net;
    std::vector<Net> agenda;
    std::vector<Protection> protections;
    OraclePlan plan;
  };

  void number_tasks(Net& net) {
    net.id = net.kind == TreeNodeKind::kTask ? ++last_id_ : 0;
    for (Net& child : net.children) number_tasks(child);
  }

  Net network(const NetworkClause& clause, std::uint32_t base, const Substitution& known) {
    Net out{clause.kind, {}, {}, clause.immediate, 0};
    for (const NetworkClause& child : clause.children) {
      out.children.push_back(network(child, base, known));
    }
    if (clause.kind != TreeNodeKind::kTask) return out;
    if (clause.items.empty()) {
      out.task = known.instance(clause.pattern, base);
      return out;
    }
    std::vector<Term> items;
    for (const NetworkClause::Item& item : clause.items) {
      items.push_back(item.code == kNoCode ? known.instance(item.pattern, base)
                                           : prover_.evaluate(item.code, base, known));
    }
    out.task = store_.list(items);
    return out;
  }

  bool finished() const { return limits_.first_only && !out_.plans.empty(); }

  void seek(const Node& node) {
    if (++out_.expansions > limits_.expansions) throw Stop(Stop::Kind::kBudget, "expansions");
    if (node.agenda.empty()) {
      out_.plans.push_back(node.plan);
      return;
    }
    if (node.plan.depth >= limits_.depth) {
      out_.cut = true;
      return;
    }
    const auto urgent = std::find_if(node.agenda.begin(), node.agenda.end(), [&](const Net& task) {
      return task.immediate || store_.car(task.task) == store_.symbol(replay::kNoOperation);
    });
    if (urgent != node.agenda.end()) return pursue(node, *urgent);
    for (auto task = node.agenda.begin(); task != node.agenda.end(); ++task) {
      // Trying an equal task again would be the same.
      const bool repeats = std::any_of(node.agenda.begin(), task, [&](const Net& before) {
        return before.task == task->task && before.immediate == task->immediate;
      });
      if (repeats && !limits_.equals_again) continue;
      pursue(node, *task);
      if (finished()) return;
    }
  }

  // The language knows tasks by what they say: of equal ones the first in the network is worked on,
  // and the first on the agenda goes.
  Node settled(Node node, const Net& chosen, int& target) const {
    const auto equal = [&](const Net& one) {
      return one.task == chosen.task && one.immediate == chosen.immediate;
    };
    std::vector<Net> ready;
    first_tasks(node.net, ready);
    target = std::find_if(ready.begin(), ready.end(), equal)->id;
    const auto gone = std::find_if(node.agenda.begin(), node.agenda.end(), equal);
    const auto worked = std::find_if(node.agenda.begin(), node.agenda.end(),
                                     [&](const Net& one) { return one.id == target; });
    std::swap(gone->id, worked->id);
    return node;
  }

  void pursue(const Node& before, const Net& chosen) {
    Net task = chosen;
    const Node node = settled(before, chosen, task.id);
    const Term name = store_.car(task.task);
    if (store_.name(name).starts_with('!')) {
      const OperatorClause* clause = clauses_.operator_named(name);
      if (clause == nullptr) throw Stop(Stop::Kind::kError, "no operator");
      return act(node, task, *clause);
    }
    for (const MethodClause& method : clauses_.methods_for(name)) {
      reduce(node, task, method);
      if (finished()) return;
    }
  }

  Node after(const Node& node, const Net& task) const {
    Node next = node;
    ++next.plan.depth;
    std::erase_if(next.agenda, [&](const Net& one) { return one.id == task.id; });
    return next;
  }

  void reduce(const Node& node, const Net& task, const MethodClause& method) {
    const std::uint32_t base = prover_.fresh(method.slots);
    Substitution known = node.known;
    if (!known.unify(known.instance(method.head, base), known.resolve(task.task))) return;
    for (const replay::BranchClause& branch : method.branches) {
      const auto answers = prover_.find(branch.precondition, base, known, false);
      if (answers.empty()) continue;
      std::vector<std::pair<Net, Substitution>> reductions;
      for (const Substitution& answer : answers) {
        for (Net& copy : with_immediate(network(branch.tasks, base, answer))) {
          const bool twice = std::any_of(reductions.begin(), reductions.end(),
                                         [&](const auto& one) { return one.first.same(copy); });
          if (!twice) reductions.emplace_back(std::move(copy), answer);
        }
      }
      for (auto& [net, answer] : reductions) {
        Node next = after(node, task);
        next.known = answer;
        number_tasks(net);
        replace(next.net, task.id, net);
        first_tasks(net, next.agenda);
        next.plan.choices.push_back("task " + std::to_string(task.id) + ' ' + branch.label + ' ' +
                                    text_of(net));
        seek(next);
        if (finished()) return;
      }
      return;
    }
  }

  std::string text_of(const Net& net) {
    if (net.kind == TreeNodeKind::kTask) {
      return (net.immediate ? "!" : "") + plain_text(store_, net.task);
    }
    std::string out = net.kind == TreeNodeKind::kOrdered ? "[" : "{";
    for (const Net& child : net.children) out += text_of(child) + ' ';
    return out + ']';
  }

  void act(const Node& node, const Net& task, const OperatorClause& clause) {
    const std::uint32_t base = prover_.fresh(clause.slots);
    Substitution known = node.known;
    if (!known.unify(known.instance(clause.head, base), known.resolve(task.task))) return;
    if (!clause.precondition.goals.empty()) {
      const auto answers = prover_.find(clause.precondition, base, known, true);
      if (answers.empty()) return;
      known = answers.front();
    }
    Node next = after(node, task);
    const Term action = known.instance(clause.head, base);
    const bool counted = store_.car(action) != store_.symbol(replay::kNoOperation);
    if (counted) {
      double cost = 1;
      if (clause.cost != kNoCode) {
        const Term value = prover_.evaluate(clause.cost, base, known);
        if (value.is(TermKind::kNumber)) cost = to_double(store_.value(value));
      }
      next.plan.steps.push_back(plain_text(store_, action));
      next.plan.costs.push_back(cost);
      next.plan.cost += cost;
    }
    next.plan.choices.push_back("step " + std::to_string(task.id));
    std::vector<Facts::Change> changes;
    if (change(clause, base, known, next.protections, changes)) {
      next.known = known;
      remove(next.net, task.id);
      advance_agenda(next);
      seek(next);
    }
    facts_.undo(changes);
  }

  // The tasks that have lost their last predecessor, at the end.
  void advance_agenda(Node& next) const {
    std::vector<Net> ready;
    first_tasks(next.net, ready);
    for (const Net& task : ready) {
      const bool known = std::any_of(next.agenda.begin(), next.agenda.end(),
                                     [&](const Net& one) { return one.id == task.id; });
      if (!known) next.agenda.push_back(task);
    }
  }

  // In the order they are carried out: what stands last in the text comes first.
  std::vector<Term> list_of(const OperatorClause& clause, EffectKind kind, EffectKind items,
                            std::uint32_t base, const Substitution& known) {
    std::vector<Term> out;
    const auto put = [&](Term atom) {
      if (clause.action) {
        out.push_back(atom);
        return;
      }
      std::erase(out, atom);
      out.insert(out.begin(), atom);
    };
    const std::function<void(const Effect&, const Substitution&)> collect =
        [&](const Effect& effect, const Substitution& here) {
          if (effect.kind == kind) put(here.instance(effect.pattern, base));
          if (effect.kind == items) {
            for (const Term item : store_.items(here.instance(effect.pattern, base))) put(item);
          }
          if (effect.kind != EffectKind::kForall && effect.kind != EffectKind::kWhen) return;
          // What adds nothing is not worked out when additions are collected.
          const bool mine = clause.action || effect.parts.empty() || effect.parts[0].kind == kind ||
                            effect.parts[0].kind == items;
          if (!mine) return;
          const bool once = effect.kind == EffectKind::kWhen;
          for (const Substitution& one : prover_.find(effect.condition, base, here, once)) {
            for (const Effect& part : effect.parts) collect(part, one);
          }
        };
    for (const Effect& effect : clause.effects) collect(effect, known);
    return out;
  }

  Term protected_goal(Term atom) {
    return atom.is(TermKind::kPair) && store_.car(atom) == store_.symbol(":protection")
               ? store_.car(store_.cdr(atom))
               : kNil;
  }

  bool change(const OperatorClause& clause, std::uint32_t base, const Substitution& known,
              std::vector<Protection>& protections, std::vector<Facts::Change>& changes) {
    const auto deletions =
        list_of(clause, EffectKind::kDelete, EffectKind::kDeleteItems, base, known);
    const auto additions = list_of(clause, EffectKind::kAdd, EffectKind::kAddItems, base, known);
    for (const Term atom : deletions) {
      const Term goal = protected_goal(atom);
      if (goal == kNil) {
        facts_.remove(atom, changes);
        continue;
      }
      const auto found = std::find_if(protections.begin(), protections.end(),
                                      [&](const Protection& one) { return one.goal == goal; });
      if (found == protections.end()) continue;
      const int count = found->count - 1;
      protections.erase(found);
      if (count > 0) protections.insert(protections.begin(), {goal, count});
    }
    for (const Term atom : additions) {
      if (protected_goal(atom) != kNil) continue;
      if (!store_.ground(atom)) throw Stop(Stop::Kind::kError, "adds a variable");
      facts_.add(atom, changes);
    }
    for (const Protection& one : protections) {
      if (!prover_.holds(one.goal, known)) return false;
    }
    for (const Term atom : additions) {
      const Term goal = protected_goal(atom);
      if (goal == kNil) continue;
      if (!prover_.holds(goal, known)) throw Stop(Stop::Kind::kError, "protects what is false");
      const auto found = std::find_if(protections.begin(), protections.end(),
                                      [&](const Protection& one) { return one.goal == goal; });
      const int count = found == protections.end() ? 0 : found->count;
      if (count > 0) protections.erase(found);
      protections.insert(protections.begin(), {goal, count + 1});
    }
    return true;
  }

  TermStore& store_;
  Facts facts_;
  const replay::Clauses& clauses_;
  OracleLimits limits_;
  Prover prover_;
  OracleOutcome out_;
  int last_id_ = 0;
};

}  // namespace

OracleOutcome brute_force(const DomainDefinition& domain,
                          const std::vector<FunctionDefinition>& functions,
                          const ProblemDefinition& problem, TermStore& store,
                          const OracleLimits& limits) {
  const Functions host;
  Lisp lisp(store, host, functions);
  Diagnostics errors;
  const replay::Clauses clauses = replay::read_clauses(domain, store, lisp, errors);
  std::uint32_t slots = 0;
  const NetworkClause tasks = replay::read_tasks(problem, store, lisp, slots, errors);
  if (!errors.empty()) {
    OracleOutcome out;
    out.error = to_text(errors);
    return out;
  }
  return Search(store, clauses, lisp, limits).run(problem, tasks, slots);
}

}  // namespace skein::htn::oracle
