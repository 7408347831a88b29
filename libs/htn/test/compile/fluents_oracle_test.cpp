// SPDX-License-Identifier: Apache-2.0
// Drawn actions on PDDL's numbers against a calculator of fractions: what an effect changes, from
// which values, and which comparisons let an action happen.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <functional>
#include <numeric>
#include <optional>

#include "testing/planner_case.hpp"

namespace skein::htn::fluents {
namespace {

using test::Case;

struct Fraction {
  std::int64_t above = 0, below = 1;

  Fraction(std::int64_t number = 0, std::int64_t divisor = 1) {
    const std::int64_t common = std::gcd(number, divisor) * (divisor < 0 ? -1 : 1);
    above = number / common;
    below = divisor / common;
  }
  std::string text() const {
    return std::to_string(above) + (below == 1 ? "" : "/" + std::to_string(below));
  }
};

Fraction operator+(const Fraction& l, const Fraction& r) {
  return {l.above * r.below + r.above * l.below, l.below * r.below};
}
Fraction operator*(const Fraction& l, const Fraction& r) {
  return {l.above * r.above, l.below * r.below};
}
Fraction operator-(const Fraction& l, const Fraction& r) { return l + Fraction(-1) * r; }
Fraction operator/(const Fraction& l, const Fraction& r) {
  return {l.above * r.below, l.below * r.above};
}
bool operator<(const Fraction& l, const Fraction& r) {
  return l.above * r.below < r.above * l.below;
}

constexpr std::size_t kFluents = 3;
using Value = std::optional<Fraction>;
using Values = std::array<Value, kFluents>;

std::string name(std::size_t fluent) { return "(f" + std::to_string(fluent) + ")"; }

/// A sum of functions and small numbers, and what it is of any values: nothing if one has none.
struct Sum {
  std::string text;
  std::function<Value(const Values&)> of;
};

Sum drawn_fluent() {
  const auto fluent = *rc::gen::inRange<std::size_t>(0, kFluents);
  return {name(fluent), [fluent](const Values& values) { return values.at(fluent); }};
}

Sum drawn_term(int depth) {
  const int kind = *rc::gen::inRange(0, depth == 0 ? 2 : 5);
  if (kind == 0) {
    const int number = *rc::gen::inRange(-4, 5);
    return {std::to_string(number), [number](const Values&) { return Value(Fraction(number)); }};
  }
  if (kind == 1) return drawn_fluent();
  const Sum left = drawn_term(depth - 1), right = drawn_term(depth - 1);
  const std::string sign(1, "+-*"[kind - 2]);
  return {"(" + sign + " " + left.text + " " + right.text + ")",
          [kind, left, right](const Values& values) -> Value {
            const Value one = left.of(values), other = right.of(values);
            if (!one || !other) return std::nullopt;
            return kind == 2 ? *one + *other : kind == 3 ? *one - *other : *one * *other;
          }};
}

struct Condition {
  std::string text;
  std::function<bool(const Values&)> holds;
};

Condition drawn_comparison() {
  const Sum left = drawn_fluent(), right = drawn_term(1);
  const int kind = *rc::gen::inRange(0, 5);
  static const std::array<std::string, 5> kSigns{"<", "<=", "=", ">=", ">"};
  return {
      "(" + kSigns.at(static_cast<std::size_t>(kind)) + " " + left.text + " " + right.text + ")",
      [kind, left, right](const Values& values) {
        const Value one = left.of(values), other = right.of(values);
        if (!one || !other) return false;
        const bool less = *one < *other, more = *other < *one;
        const std::array<bool, 5> results{less, !more, !less && !more, !less, more};
        return results.at(static_cast<std::size_t>(kind));
      }};
}

Condition drawn_condition() {
  const Condition one = drawn_comparison(), other = drawn_comparison();
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      return one;
    case 1:
      return {"(and " + one.text + " " + other.text + ")",
              [=](const Values& values) { return one.holds(values) && other.holds(values); }};
    case 2:
      return {"(or " + one.text + " " + other.text + ")",
              [=](const Values& values) { return one.holds(values) || other.holds(values); }};
    default:
      return {"(not " + one.text + ")", [=](const Values& values) { return !one.holds(values); }};
  }
}

struct Effect {
  std::string text;
  std::size_t fluent = 0;
  std::function<Value(const Values&)> value;
};

Effect drawn_effect(std::size_t fluent) {
  const int kind = *rc::gen::inRange(0, 5);
  static const std::array<std::string, 5> kNames{"assign", "increase", "decrease", "scale-up",
                                                 "scale-down"};
  Sum by = drawn_term(2);
  if (kind == 4) {
    const int divisor = *rc::gen::inRange(1, 4);
    by = {std::to_string(divisor), [divisor](const Values&) { return Value(Fraction(divisor)); }};
  }
  return {
      "(" + kNames.at(static_cast<std::size_t>(kind)) + " " + name(fluent) + " " + by.text + ")",
      fluent, [=](const Values& values) -> Value {
        const Value old_value = values.at(fluent), change = by.of(values);
        if (!old_value || !change) return old_value;
        switch (kind) {
          case 0:
            return change;
          case 1:
            return *old_value + *change;
          case 2:
            return *old_value - *change;
          case 3:
            return *old_value * *change;
          default:
            return *old_value / *change;
        }
      }};
}

struct Action {
  Condition condition = drawn_condition();
  std::vector<Effect> effects;

  Action() {
    for (std::size_t fluent = 0; fluent < kFluents; ++fluent)
      if (*rc::gen::arbitrary<bool>()) effects.push_back(drawn_effect(fluent));
  }
  std::string text(std::size_t number) const {
    std::string out = "(:action a" + std::to_string(number) + " :parameters () :precondition " +
                      condition.text + " :effect (and (done" + std::to_string(number) + ")";
    for (const Effect& effect : effects) out += " " + effect.text;
    return out + "))";
  }
  /// All effects are worked out from the values before.
  Values after(const Values& before) const {
    Values values = before;
    for (const Effect& effect : effects) values.at(effect.fluent) = effect.value(before);
    return values;
  }
};

Values drawn_values() {
  Values values;
  for (Value& value : values)
    if (*rc::gen::inRange(0, 8) > 0) value = Fraction(*rc::gen::inRange(-5, 6));
  return values;
}

std::string facts(const Values& values) {
  std::string text;
  for (std::size_t fluent = 0; fluent < kFluents; ++fluent)
    if (values.at(fluent)) text += "(= " + name(fluent) + " " + values.at(fluent)->text() + ")";
  return text;
}

/// A world of two actions, and one more that happens only where the functions have given values.
struct World {
  std::array<Action, 2> actions;
  Values start = drawn_values();

  /// With a first action that happens at the start.
  World& begun() {
    Condition& first = actions[0].condition;
    if (first.holds(start)) return *this;
    first = {"(not " + first.text + ")",
             [wrong = first](const Values& values) { return !wrong.holds(values); }};
    return *this;
  }
  std::string items(const Values& expected) const {
    std::string text = "(:functions (f0) (f1) (f2))";
    for (std::size_t number = 0; number < actions.size(); ++number)
      text += actions.at(number).text(number);
    return text + "(:action look :parameters () :precondition (and (done0) " + shown(expected) +
           ") :effect (seen))";
  }
  /// A function without a value satisfies no comparison, not even with itself.
  static std::string shown(const Values& values) {
    std::string text;
    for (std::size_t fluent = 0; fluent < kFluents; ++fluent) {
      const Value& value = values.at(fluent);
      text += value ? "(= " + name(fluent) + " " + value->text() + ")"
                    : "(not (= " + name(fluent) + " " + name(fluent) + "))";
    }
    return text;
  }
  std::string planned(const Values& expected, const std::string& tasks) const {
    const std::string items_text = items(expected);
    RC_LOG() << items_text << "\n" << facts(start) << "\n" << tasks << "\n";
    return Case(items_text, facts(start), tasks).first();
  }
};

RC_GTEST_PROP(FluentsOracle, AnActionHappensWhereItsComparisonsHold, ()) {
  const World world;

  const std::string plan = world.planned(world.start, "((!a0))");

  RC_ASSERT(plan == (world.actions[0].condition.holds(world.start) ? "(!a0)" : "no plan"));
}

RC_GTEST_PROP(FluentsOracle, EffectsAreWorkedOutFromTheValuesBefore, ()) {
  const World world = World().begun();
  const Values once = world.actions[0].after(world.start);

  RC_ASSERT(world.planned(once, "((!a0) (!look))") == "(!a0) (!look)");

  Values wrong = once;
  const auto fluent = *rc::gen::inRange<std::size_t>(0, kFluents);
  wrong.at(fluent) = once.at(fluent) ? *once.at(fluent) + Fraction(1, 7) : Fraction(0);
  RC_ASSERT(world.planned(wrong, "((!a0) (!look))") == "no plan");
}

RC_GTEST_PROP(FluentsOracle, ActionsFollowOnTheValuesOfThoseBefore, ()) {
  const World world = World().begun();
  const Values once = world.actions[0].after(world.start);
  const bool again = world.actions[1].condition.holds(once);

  RC_ASSERT(world.planned(again ? world.actions[1].after(once) : once, "((!a0) (!a1) (!look))") ==
            (again ? "(!a0) (!a1) (!look)" : "no plan"));
}

}  // namespace
}  // namespace skein::htn::fluents
