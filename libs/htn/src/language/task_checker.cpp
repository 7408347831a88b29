// SPDX-License-Identifier: Apache-2.0
#include "language/task_checker.hpp"

#include <algorithm>

#include "skein/foundation/nearest.hpp"

namespace skein::htn {

void TaskChecker::check(Expression tasks) {
  if (!tasks) return;
  open_.push_back(tasks);
  while (!open_.empty()) {
    const Expression at = open_.back();
    open_.pop_back();
    check_one(unquoted(at, context_.words));
  }
}

void TaskChecker::check_one(Expression tasks) {
  if (context_.is_nil(tasks)) return;
  if (!context_.is_list(tasks)) {
    return context_.error(tasks, text_of(tasks) + " is no task",
                          "(name arguments…) or a list of tasks");
  }
  const Expression begin = first(tasks);
  if (context_.is_list(begin)) return push_from(begin);
  if (!context_.is_symbol(begin)) {
    return context_.error(begin, "a task named " + text_of(begin), "a name");
  }
  const Term word = (*begin).atom;
  const Words& words = context_.words;
  if (word == words.ordered || word == words.unordered) {
    if (next(begin)) push_from(next(begin));
    return;
  }
  if (word == words.comma || word == words.comma_at) {
    return context_.error(tasks, "a computed task list", "tasks; (call …) computes an argument");
  }
  check_task(tasks);
}

void TaskChecker::push_from(Expression begin) {
  const std::size_t bottom = open_.size();
  for (Expression at = begin; at; at = next(at)) open_.push_back(at);
  std::reverse(open_.begin() + static_cast<std::ptrdiff_t>(bottom), open_.end());
}

void TaskChecker::check_task(Expression task) {
  const Words& words = context_.words;
  Expression name = first(task);
  if ((*name).atom == words.task) name = next(name);
  if (name && context_.is_symbol(name) && (*name).atom == words.immediate) name = next(name);
  if (!name || !context_.is_symbol(name) || context_.is_nil(name)) {
    return context_.error(name ? name : task, "a task without a name", "(name arguments…)");
  }
  const std::string text = context_.name(name);
  if (text.starts_with(':')) {
    // SHOP3 takes any word; what is nearly a keyword is most likely a slip.
    const std::string meant = nearest_name(text, {":ordered", ":unordered", ":task", ":immediate"});
    const std::string expected = ":ordered, :unordered, :task or :immediate";
    if (!meant.empty()) {
      return context_.error(name, "unknown keyword " + text + " in a task list", expected, meant);
    }
    context_.warn(name, "keyword " + text + " as the name of a task", expected);
  }
  if (context_.is_variable(name)) return;
  TaskUse use{task, (*name).atom, 0, (*task).dotted};
  for (Expression at = next(name); at; at = next(at)) ++use.arguments;
  if (use.open) --use.arguments;
  tasks_.push_back(use);
}

}  // namespace skein::htn
