// SPDX-License-Identifier: Apache-2.0
#include "testing/repair_fixture.hpp"

#include <gtest/gtest.h>

#include "skein/htn_tools/validator.hpp"
#include "testing/sample_plan.hpp"

namespace skein::htn::testing {

namespace {

Result<std::string, Failure> no_include(const std::string&, const std::string&) {
  return failure("nothing to include");
}

std::string text_of(Expression expression) {
  if (!expression) return "()";
  const Node& node = *expression;
  return expression.document->text.substr(node.begin, node.end - node.begin);
}

/// The old problem and plan with each divergence as operators and steps. Executed steps that have
/// lost their task, and the divergences, are tasks of the problem themselves.
class Injected {
 public:
  Injected(const Plan& plan, const std::vector<Divergence>& divergences, TermStore& store)
      : plan_(plan), divergences_(divergences), store_(store) {
    for (std::size_t at = 0; at < divergences.size(); ++at) inject(at);
  }

  const std::string& operators() const { return operators_; }

  std::string tasks(const std::string& given) const {
    std::string out = given;
    for (const std::vector<TreeIndex>& homeless : homeless_networks()) {
      std::string steps = "(:ordered";
      for (const TreeIndex step : homeless) steps += " " + store_.to_text(plan_.tree[step].task);
      out = "(:unordered " + steps + ") " + out + ")";
    }
    std::string outside;
    for (const auto& [after, name] : steps_) outside += " (" + name + ")";
    return "(:unordered" + outside + " " + out + ")";
  }

  GivenPlan plan() const {
    GivenPlan out;
    GivenNode root;
    root.kind = TreeNodeKind::kUnordered;
    out.tree.push_back(root);
    auto injected = steps_.begin();
    std::vector<StepIndex> place(plan_.steps.size());
    for (StepIndex step = 0; step <= plan_.steps.size(); ++step) {
      for (; injected != steps_.end() && injected->first == step; ++injected) {
        GivenNode node;
        node.kind = TreeNodeKind::kStep;
        node.task = store_.pair(store_.symbol(injected->second), kNil);
        node.step = static_cast<StepIndex>(out.steps.size());
        out.tree[0].children.push_back(static_cast<TreeIndex>(out.tree.size()));
        out.tree.push_back(node);
        out.steps.push_back({node.task, {}, 0});
      }
      if (step == plan_.steps.size()) break;
      place[step] = static_cast<StepIndex>(out.steps.size());
      out.steps.push_back({plan_.steps[step].action, plan_.steps[step].cost, 0});
    }
    const auto first = static_cast<TreeIndex>(out.tree.size());
    out.tree[0].children.push_back(first);
    for (const TreeNode& node : plan_.tree) {
      GivenNode given{node.kind, node.children, node.task, node.method, node.step};
      for (TreeIndex& child : given.children) child += first;
      if (given.step < place.size()) given.step = place[given.step];
      out.tree.push_back(given);
    }
    out.cost = plan_.cost;
    return out;
  }

 private:
  void inject(std::size_t at) {
    const StepIndex after = divergences_[at].after;
    std::string lost;
    std::string gained;
    for (const Change& change : net(at)) {
      const std::string fact = store_.to_text(change.fact);
      (change.added ? gained : lost) += fact;
      // What the world makes false is protected no more, however often it was.
      for (StepIndex step = 0; !change.added && step < after; ++step) {
        add_operator(after, "((:protection " + fact + ")) ()");
      }
    }
    add_operator(after, "(" + lost + ") (" + gained + ")");
  }
  void add_operator(StepIndex after, const std::string& effects) {
    const std::string name = "!!outside-" + std::to_string(steps_.size());
    operators_ += "(:operator (" + name + ") () " + effects + " 0)\n";
    steps_.emplace_back(after, name);
  }

  // The last change of each fact: an operator deletes before it adds.
  std::vector<Change> net(std::size_t at) const {
    std::vector<Change> out;
    for (const Change& change : divergences_[at].changes) {
      std::erase_if(out, [&](const Change& known) { return known.fact == change.fact; });
      out.push_back(change);
    }
    return out;
  }

  // Innermost first: repairs of repairs wrap again.
  std::vector<std::vector<TreeIndex>> homeless_networks() const {
    std::vector<std::vector<TreeIndex>> out;
    for (TreeIndex at = 0; wraps(at); at = plan_.tree[at].children[1]) {
      out.insert(out.begin(), plan_.tree[plan_.tree[at].children[0]].children);
    }
    return out;
  }
  bool wraps(TreeIndex at) const {
    const TreeNode& node = plan_.tree[at];
    return node.kind == TreeNodeKind::kUnordered && node.children.size() == 2 &&
           plan_.tree[node.children[0]].kind == TreeNodeKind::kOrdered &&
           plan_.tree[node.children[1]].kind != TreeNodeKind::kTask &&
           !plan_.tree[node.children[0]].children.empty() &&
           plan_.tree[plan_.tree[node.children[0]].children[0]].kind == TreeNodeKind::kStep;
  }

  const Plan& plan_;
  const std::vector<Divergence>& divergences_;
  TermStore& store_;
  std::string operators_;
  std::vector<std::pair<StepIndex, std::string>> steps_;  // after how many of the plan, and which
};

}  // namespace

RepairFixture::RepairFixture(const std::string& text) : text_(text) {
  Diagnostics errors;
  Diagnostics warnings;
  read_definitions({"test.lisp", text}, store_, no_include, definitions_, errors, warnings);
  if (definitions_.domains.size() == 1 && definitions_.problems.size() == 1) {
    domain_ =
        Domain::compile(definitions_.domains[0], definitions_.functions, host_, store_, errors);
    problem_ = make_problem(definitions_.problems[0], store_);
  }
  EXPECT_TRUE(errors.empty() && domain_ != nullptr) << to_text(errors);
}

const Plan& RepairFixture::make_plan(const Limits& limits) {
  Options options;
  options.trees = true;
  options.limits = limits;
  Outcome outcome = htn::plan(*domain_, problem_, options);
  plan_ = outcome.plans.empty() ? Plan{} : std::move(outcome.plans[0]);
  return plan_;
}

Term RepairFixture::term(const std::string& text) { return testing_plans::term(text, store_); }

RepairFixture& RepairFixture::diverge(StepIndex after, const std::vector<std::string>& changes) {
  std::vector<Change> made;
  for (const std::string& change : changes) {
    const bool added = !change.starts_with('-');
    made.push_back({added, term(added ? change : change.substr(1))});
  }
  return diverge(after, made);
}

RepairFixture& RepairFixture::diverge(StepIndex after, const std::vector<Change>& changes) {
  divergences_.push_back({after, changes});
  return *this;
}

const Repair& RepairFixture::repair(StepIndex executed, const RepairOptions& options,
                                    const Host& host) {
  executed_ = executed;
  repair_ = htn::repair(*domain_, problem_, {&plan_, executed, divergences_}, options, host);
  return repair_;
}

std::string RepairFixture::fault(bool with_tree) const {
  for (StepIndex step = 0; step < executed_; ++step) {
    const Step& now = repair_.plan.steps.at(step);
    if (now != plan_.steps[step]) return "executed step " + text(now.action) + " was changed";
  }
  return fault_of(repair_.plan, divergences_, with_tree);
}

std::string RepairFixture::fault_of(const Plan& plan, const std::vector<Divergence>& divergences,
                                    bool with_tree) const {
  const Injected injected(plan, divergences, store_);
  std::string changed = text_;
  const std::string head = "(defdomain d (";
  changed.insert(changed.find(head) + head.size(), "\n" + injected.operators());
  const ProblemDefinition& problem = definitions_.problems[0];
  changed += "(defproblem injected d " + text_of(problem.facts) + "\n" +
             injected.tasks(text_of(problem.tasks)) + ")";
  Diagnostics errors;
  Diagnostics warnings;
  Definitions definitions;
  read_definitions({"changed.lisp", changed}, store_, no_include, definitions, errors, warnings);
  if (!errors.empty()) return changed + to_text(errors);
  const Validator validator(definitions.domains[0], definitions.functions, host_, store_, errors);
  GivenPlan given = injected.plan();
  if (!with_tree) given.tree.clear();
  const Validation validation = validator.validate(definitions.problems[1], given);
  return validation.fault ? to_text(validation) : "";
}

std::vector<std::string> RepairFixture::rest() const { return actions(repair_.plan, executed_); }

std::vector<std::string> RepairFixture::actions(const Plan& plan, StepIndex from) const {
  std::vector<std::string> out;
  for (StepIndex step = from; step < plan.steps.size(); ++step) {
    out.push_back(text(plan.steps[step].action));
  }
  return out;
}

std::vector<std::string> RepairFixture::actions(const Plan& plan,
                                                const std::vector<StepIndex>& steps) const {
  std::vector<std::string> out;
  for (const StepIndex step : steps) out.push_back(text(plan.steps.at(step).action));
  return out;
}

std::vector<std::string> RepairFixture::redone() const {
  std::vector<std::string> out;
  for (const Redone& one : repair_.redone) {
    out.push_back((one.begun ? "again " : "") + text(one.task));
  }
  return out;
}

std::string RepairFixture::describe() const {
  std::string out = text_ + "plan:";
  for (const std::string& action : actions(plan_)) out += " " + action;
  out += "\nexecuted: " + std::to_string(executed_) + "\nchanges:";
  for (const Divergence& divergence : divergences_) {
    for (const Change& change : divergence.changes) {
      out += (change.added ? " +" : " -") + text(change.fact);
    }
  }
  out += "\nverdict " + std::to_string(static_cast<int>(repair_.verdict)) + " " + repair_.why +
         "\nrepaired:";
  for (const std::string& action : actions(repair_.plan)) out += " " + action;
  for (const std::string& task : redone()) out += "\nredone " + task;
  return out + "\n" + (repair_.plan.tree.empty() ? "" : fault()) + "\n";
}

}  // namespace skein::htn::testing
