// SPDX-License-Identifier: Apache-2.0
#include "search/search.hpp"

#include <algorithm>

#include "skein/htn/term_map.hpp"

namespace skein::htn {

namespace {

const Method& method_at(const std::vector<Method>& methods, std::uint32_t position,
                        std::uint32_t preferred) {
  if (preferred == kAbsent) return methods[position];
  if (position == 0) return methods[preferred];
  return methods[position <= preferred ? position - 1 : position];
}

bool by_bits(Term left, Term right) { return left.bits() < right.bits(); }

// Variables of a problem's tasks become cells.
TaskNetwork with_cells(const TaskNetwork& network, TermStore& store, Bindings& bindings,
                       std::uint32_t& opened) {
  TaskNetwork made = network;
  const auto cell = [&](Term local) {
    if (local.index() >= opened) {
      bindings.open(local.index() + 1 - opened);
      opened = local.index() + 1;
    }
    return Term(TermKind::kVariable, local.index());
  };
  if (made.kind == NetworkKind::kTask) made.task = map_leaves(store, made.task, kHasLocal, cell);
  for (TaskNetwork& child : made.children) child = with_cells(child, store, bindings, opened);
  return made;
}

}  // namespace

Search::Search(const Domain& domain, const Problem& problem, const Options& options,
               const Host& host)
    : domain_(domain.compiled()),
      store_(domain.store()),
      options_(options),
      host_(host),
      bindings_(store_),
      facts_(store_),
      agenda_(store_),
      problem_(problem),
      traced_(by_bits),
      preferences_(options.preferences, store_) {
  for (const std::string& name : options.traced_tasks) traced_.insert(store_.symbol(name));
  domain_.lisp.begin();
  if (options.trees) facts_.record_deleters();
  for (const Term fact : problem.facts) facts_.add(fact, kInitialState);
  std::uint32_t opened = 0;
  agenda_.start(with_cells(problem.tasks, store_, bindings_, opened));
  forget();
}

void Search::run(const Deepening& deepening, Budget& budget) {
  deepening_ = deepening;
  cutoff_ = deepening.cutoff;
  const std::size_t relived = relive(budget);
  if (relived < problem_.past.size()) {
    const std::string why = *steps_made_->why() == '\0' ? "no such operator" : steps_made_->why();
    budget.fail("the step " + store_.to_text(problem_.past[relived].term) +
                ", said to be executed, does not apply: " + why);
  }
  Move move = Move::kExpand;
  while (move != Move::kStop && !budget.stopped()) {
    move = move == Move::kExpand ? expand() : back();
  }
}

std::size_t Search::relive(Budget& budget) {
  budget_ = &budget;
  prover_.emplace(domain_, bindings_, facts_, budget);
  prover_->record_support(options_.trees);
  reducer_.emplace(domain_, bindings_, *prover_, budget, pool_);
  steps_made_.emplace(domain_, bindings_, facts_, protections_, *prover_, budget);
  steps_made_->record_changes(options_.states);
  std::size_t relived = 0;
  bool outside = false;
  for (; relived < problem_.past.size() && !budget.stopped(); ++relived) {
    const Event& event = problem_.past[relived];
    if (outside && event.kind == Event::Kind::kStep) drop_broken_protections();
    outside = event.kind != Event::Kind::kStep;
    if (!relive(event)) break;
  }
  if (outside) drop_broken_protections();
  forget();
  return relived;
}

Search::Move Search::expand() {
  if (!budget_->expand()) return Move::kStop;
  course_.deepest = std::max(course_.deepest, depth_);
  if (agenda_.empty()) return found();
  const bool too_deep = cutoff_ && depth_ >= *cutoff_;
  if (too_deep || (options_.limits.depth && depth_ >= *options_.limits.depth)) {
    course_.cut_by_depth = true;
    if (options_.explain_failure && !cut_ && !explain_at_) cut_ = standing();
    return Move::kBack;
  }
  const NodeId immediate = agenda_.first_immediate();
  if (immediate != kNoNodeId) return attempt(immediate);
  const NodeId first = preferences_.empty() ? agenda_.first() : preferred_node();
  const bool in_turn = first == agenda_.first();
  const NodeId second = in_turn ? agenda_.next_distinct(first) : agenda_.first();
  if (second != kNoNodeId) {
    Choice& choice = push_choice(ChoiceKind::kTask, second);
    if (!in_turn) choice.tried = first;
  }
  return attempt(first);
}

Search::Move Search::back() {
  if (choices_.empty()) return Move::kStop;
  Choice& choice = choices_.back();
  restore(choice);
  if (choice.kind == ChoiceKind::kTask) {
    const NodeId node = choice.node;
    choice.node = behind(node, choice.tried);
    if (choice.node == kNoNodeId) choices_.pop_back();
    return attempt(node);
  }
  const NodeId node = choice.node;
  if (choice.reduction < choice.reductions_end) {
    const std::uint32_t index = choice.reduction++;
    if (choice.reduction == choice.reductions_end && choice.method == choice.methods)
      choices_.pop_back();
    return take_reduction(node, index);
  }
  pool_.cut(choice.pool);
  const std::uint32_t method = choice.method;
  const std::uint32_t preferred = choice.preferred;
  choices_.pop_back();
  return attempt_methods(node, bindings_.instance(agenda_[node].task, 0), method, preferred);
}

Search::Move Search::attempt(NodeId node) {
  node = agenda_.twin(node);
  const Term task = bindings_.instance(agenda_[node].task, 0);
  if (!task.is(TermKind::kPair)) {
    budget_->fail("a task must be a list that begins with its name, not " + store_.to_text(task));
    return Move::kStop;
  }
  if (host_.trace && traced(task)) tell(TraceKind::kTask, task, "", 0, "");
  const Term name = store_.car(task);
  if (primitive(store_, name)) return attempt_step(node, task);
  const auto methods = domain_.methods.find(name);
  const std::uint32_t preferred = methods == domain_.methods.end() || preferences_.empty()
                                      ? kAbsent
                                      : preferred_method(task, methods->second);
  return attempt_methods(node, task, 0, preferred);
}

Search::Move Search::attempt_step(NodeId node, Term task) {
  const auto operation = domain_.operators.find(store_.car(task));
  MadeStep made;
  const auto position = static_cast<StepIndex>(steps_.size());
  if (operation == domain_.operators.end() ||
      !steps_made_->apply(operation->second, task, position, made)) {
    if (budget_->stopped()) return Move::kStop;
    if (host_.trace && traced(task)) {
      const bool known = operation != domain_.operators.end();
      std::string why = known ? steps_made_->why() : "no such operator";
      if (known && steps_made_->precondition_failed()) {
        why += explainer().step_unmet_text(operation->second, task);
      }
      tell(TraceKind::kStepFails, task, "", 0, std::move(why));
    }
    dead_end(node, task);
    return Move::kBack;
  }
  const Result<Number, Failure> cost = add(cost_, made.cost);
  if (!cost) {
    budget_->fail("the cost of the plan: " + cost.error().why);
    return Move::kStop;
  }
  cost_ = *cost;
  course_.negative_cost = course_.negative_cost || less_value(made.cost, integer(0));
  if (!affordable(cost_) || !follows(made.action)) return Move::kBack;
  if (host_.trace && traced(task)) tell(TraceKind::kStep, made.action, "", 0, to_text(made.cost));
  agenda_.finish(node, position);
  steps_.push_back({made.action, made.cost, std::move(made.support), std::move(made.change)});
  if (!preferences_.empty()) preferences_.use(made.action);
  ++depth_;
  if (choices_.empty()) forget();
  return Move::kExpand;
}

// The methods in order; the first that has reductions is entered, the others wait.
Search::Move Search::attempt_methods(NodeId node, Term task, std::uint32_t from,
                                     std::uint32_t preferred) {
  const auto found = domain_.methods.find(store_.car(task));
  static const std::vector<Method> kNone;
  const std::vector<Method>& methods = found == domain_.methods.end() ? kNone : found->second;
  const ReductionPool::Mark before = pool_.mark();
  const bool told = host_.trace && traced(task);
  for (std::uint32_t position = from; position < methods.size(); ++position) {
    const Reducer::Tell teller_of_task =
        told ? teller(task, position + 1, methods.size() == 1) : Reducer::Tell{};
    reducer_->reduce(method_at(methods, position, preferred), task, teller_of_task);
    if (budget_->stopped()) return Move::kStop;
    const auto end = static_cast<std::uint32_t>(pool_.reductions.size());
    if (end == before.reductions) continue;
    if (!preferences_.empty()) prefer(task, before.reductions);
    const bool more = end > before.reductions + 1 || position + 1 < methods.size();
    if (more) {
      Choice& choice = push_choice(ChoiceKind::kMethod, node);
      choice.pool = before;
      choice.pool_end = pool_.mark();
      choice.method = position + 1;
      choice.methods = static_cast<std::uint32_t>(methods.size());
      choice.reduction = before.reductions + 1;
      choice.reductions_end = end;
      choice.preferred = preferred;
    }
    const Move move = take_reduction(node, before.reductions);
    if (!more) pool_.cut(before);
    return move;
  }
  if (host_.trace && traced(task)) tell(TraceKind::kBacktrack, task, "", 0, "");
  dead_end(node, task);
  return Move::kBack;
}

Search::Move Search::take_reduction(NodeId node, std::uint32_t index) {
  const Reduction reduction = pool_.reductions[index];
  if (!preferences_.empty()) preferences_.use(bindings_.instance(agenda_[node].task, 0));
  const Term* tasks = reducer_->install(reduction);
  const Term task = agenda_[node].task;
  const auto note = static_cast<std::uint32_t>(notes_.size());
  if (options_.trees) {
    notes_.push_back({reduction.branch, pool_.support[reduction.support]});
  } else if (options_.explain_failure) {
    notes_.push_back({reduction.branch, {}});
  }
  agenda_.reduce(node, *reduction.branch, reduction.branch->forcings[reduction.forcing], tasks,
                 note);
  if (host_.trace && traced(task)) {
    std::string subtasks;
    for (std::size_t leaf = 0; leaf < reduction.branch->leaves.size(); ++leaf) {
      subtasks += (leaf == 0 ? "" : " ") + store_.to_text(bindings_.instance(tasks[leaf], 0));
    }
    tell(TraceKind::kReduction, task, reduction.branch->label, 0, std::move(subtasks));
  }
  ++depth_;
  if (choices_.empty()) forget();
  return Move::kExpand;
}

Search::Choice& Search::push_choice(ChoiceKind kind, NodeId node) {
  Choice& choice = choices_.emplace_back();
  choice.kind = kind;
  choice.node = node;
  choice.depth = depth_;
  choice.cost = cost_;
  choice.bindings = bindings_.mark();
  choice.facts = facts_.mark();
  choice.agenda = agenda_.mark();
  choice.protections = protections_.mark();
  choice.pool = pool_.mark();
  choice.pool_end = choice.pool;
  choice.preferences = preferences_.mark();
  choice.steps = static_cast<std::uint32_t>(steps_.size());
  choice.followed = followed_;
  choice.notes = static_cast<std::uint32_t>(notes_.size());
  return choice;
}

void Search::restore(const Choice& choice) {
  bindings_.undo(choice.bindings);
  facts_.undo(choice.facts);
  agenda_.undo(choice.agenda);
  protections_.undo(choice.protections);
  pool_.cut(choice.pool_end);
  preferences_.undo(choice.preferences);
  steps_.resize(choice.steps);
  notes_.resize(choice.notes);
  followed_ = choice.followed;
  depth_ = choice.depth;
  cost_ = choice.cost;
}

// Nothing can be undone any more.
void Search::forget() {
  bindings_.forget_trail();
  facts_.forget_trail();
  agenda_.forget_trail();
  protections_.forget_trail();
}

std::size_t Search::memory_bytes() const {
  std::size_t bytes =
      bindings_.memory_bytes() + facts_.memory_bytes() + agenda_.memory_bytes() +
      pool_.memory_bytes() + store_.memory_bytes() + choices_.capacity() * sizeof(Choice) +
      steps_.capacity() * sizeof(StepRecord) + notes_.capacity() * sizeof(ReductionNote);
  if (prover_) bytes += prover_->memory_bytes();
  return bytes;
}

}  // namespace skein::htn
