// SPDX-License-Identifier: Apache-2.0
#include "proof/evaluator.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace skein::htn {

std::string place_text(Expression where) {
  if (where.document == nullptr) return "";
  if (!where) return where.document->file;
  const Place place = place_of(*where.document, (*where).begin);
  return where.document->file + ":" + std::to_string(place.line) + ":" +
         std::to_string(place.column);
}

std::optional<Term> Evaluator::value_of(CodeIndex code, Base base) {
  const auto value = domain_.lisp.evaluate(code, [this, base](std::uint32_t slot) {
    return bindings_.instance(Term(TermKind::kSlot, slot), base);
  });
  if (value) return *value;
  budget_.fail(place_text(value.error().where) + ": " + value.error().why);
  return std::nullopt;
}

bool Evaluator::bind(Term pattern, Base base, Term value) {
  const Term known = bindings_.resolve(pattern, base);
  if (known.is(TermKind::kVariable)) {
    if (known != value) bindings_.bind(known, value);
    return true;
  }
  return store_.loose(bindings_.instance(known, base)) == store_.loose(value);
}

bool Evaluator::sort(const Condition& condition, Base base, Answers& answers) {
  std::vector<Term> keys;
  for (std::size_t row = 0; row < answers.count(); ++row) {
    const Bindings::Mark mark = bindings_.mark();
    answers.apply(row, bindings_);
    const std::optional<Term> key = value_of(condition.sort_key, base);
    bindings_.undo(mark);
    if (!key) return false;
    keys.push_back(*key);
  }
  std::vector<std::size_t> order(answers.count());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t left, std::size_t right) {
    return before(condition, keys[left], keys[right]);
  });
  if (budget_.stopped()) return false;
  answers.reorder(order);
  return true;
}

bool Evaluator::before(const Condition& condition, Term left, Term right) {
  if (condition.compare == kNoCode) {
    if (left.is(TermKind::kNumber) && right.is(TermKind::kNumber)) {
      return less_value(store_.value(left), store_.value(right));
    }
    budget_.fail(place_text(condition.where) + ": :sort-by compares numbers, not " +
                 store_.to_text(left) + " and " + store_.to_text(right));
    return false;
  }
  const std::array<Term, 2> arguments{left, right};
  const auto result =
      domain_.lisp.apply(condition.compare, arguments, [](std::uint32_t) { return kNil; });
  if (!result) {
    budget_.fail(place_text(result.error().where) + ": " + result.error().why);
    return false;
  }
  return *result != kNil;
}

}  // namespace skein::htn
