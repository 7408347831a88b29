// SPDX-License-Identifier: Apache-2.0
// C++ functions offered to domains as they are: arguments are checked and converted by their types.
#pragma once

#include <any>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/htn/functions.hpp"

namespace skein::htn {

/// Name of a C++ type whose values pass through the planner as opaque objects: what a plan shows
/// ("#<path>") and what a wrong argument is told. Specialise it for types of your own.
template <class Object>
struct ObjectName {
  static constexpr std::string_view kValue = "host object";
};

/// How a C++ type is read from a term and written as one. `read` gives nothing for other terms.
/// Types: bool (nil is false), std::int64_t, double (from any number; written in double
/// precision), std::string (from a string or a symbol), Term, std::vector of these (a list),
/// std::shared_ptr<const T> (an opaque object).
template <class Value>
struct HostValue;

template <>
struct HostValue<bool> {
  static std::string expected() { return "t or nil"; }
  static std::optional<bool> read(const TermStore& /*store*/, Term term) { return term != kNil; }
  static Result<Term, Failure> write(TermStore& /*store*/, bool value) {
    return TermStore::boolean(value);
  }
};

template <>
struct HostValue<std::int64_t> {
  static std::string expected() { return "an integer"; }
  static std::optional<std::int64_t> read(const TermStore& store, Term term) {
    if (!term.is(TermKind::kNumber)) return std::nullopt;
    const Number& number = store.value(term);
    if (number.kind != NumberKind::kInteger) return std::nullopt;
    return number.numerator;
  }
  static Result<Term, Failure> write(TermStore& store, std::int64_t value) {
    return store.integer(value);
  }
};

template <>
struct HostValue<double> {
  static std::string expected() { return "a number"; }
  static std::optional<double> read(const TermStore& store, Term term) {
    if (!term.is(TermKind::kNumber)) return std::nullopt;
    return to_double(store.value(term));
  }
  static Result<Term, Failure> write(TermStore& store, double value) {
    if (!std::isfinite(value)) return failure("the result is not a finite number");
    return store.number(real(value));
  }
};

template <>
struct HostValue<std::string> {
  static std::string expected() { return "a string or a symbol"; }
  static std::optional<std::string> read(const TermStore& store, Term term) {
    if (term.is(TermKind::kString)) return store.text(term);
    if (term.is(TermKind::kSymbol)) return std::string(store.name(term));
    return std::nullopt;
  }
  static Result<Term, Failure> write(TermStore& store, const std::string& value) {
    return store.string(value);
  }
};

template <>
struct HostValue<Term> {
  static std::string expected() { return "a term"; }
  static std::optional<Term> read(const TermStore& /*store*/, Term term) { return term; }
  static Result<Term, Failure> write(TermStore& /*store*/, Term value) { return value; }
};

template <class Item>
struct HostValue<std::vector<Item>> {
  static std::string expected() { return "a list, each item " + HostValue<Item>::expected(); }
  static std::optional<std::vector<Item>> read(const TermStore& store, Term term) {
    if (!store.is_list(term)) return std::nullopt;
    std::vector<Item> items;
    for (; term != kNil; term = store.cdr(term)) {
      std::optional<Item> item = HostValue<Item>::read(store, store.car(term));
      if (!item) return std::nullopt;
      items.push_back(std::move(*item));
    }
    return items;
  }
  static Result<Term, Failure> write(TermStore& store, const std::vector<Item>& value) {
    std::vector<Term> items;
    for (const Item& item : value) {
      const auto term = HostValue<Item>::write(store, item);
      if (!term) return term;
      items.push_back(*term);
    }
    return store.list(items);
  }
};

/// Null pointers are written as nil; nil is not read.
template <class Object>
struct HostValue<std::shared_ptr<const Object>> {
  using Pointer = std::shared_ptr<const Object>;
  static std::string expected() { return "#<" + std::string(ObjectName<Object>::kValue) + ">"; }
  static std::optional<Pointer> read(const TermStore& store, Term term) {
    if (!term.is(TermKind::kObject)) return std::nullopt;
    const auto* pointer = std::any_cast<Pointer>(&store.host_value(term));
    return pointer == nullptr ? std::nullopt : std::optional<Pointer>(*pointer);
  }
  static Result<Term, Failure> write(TermStore& store, const Pointer& value) {
    if (value == nullptr) return kNil;
    return store.object(std::make_shared<const std::any>(value),
                        std::string(ObjectName<Object>::kValue));
  }
};

/// A function with its name and number of arguments, for Functions::add.
struct TypedFunction {
  std::string name;
  std::size_t arguments = 0;
  HostFunction function;
};

namespace detail {

template <class Value>
struct Unwrapped {
  using Type = Value;
};
template <class Value>
struct Unwrapped<Result<Value, Failure>> {
  using Type = Value;
};

template <class Value>
bool read_argument(const TermStore& store, std::span<const Term> arguments, std::size_t at,
                   std::optional<Value>& out, std::string& wrong) {
  out = HostValue<Value>::read(store, arguments[at]);
  if (out) return true;
  wrong = "argument " + std::to_string(at + 1) + " is " + store.to_text(arguments[at]) +
          ", expected " + HostValue<Value>::expected();
  return false;
}

template <class Outcome, class... Arguments, std::size_t... kAt>
Result<Term, Failure> call_typed(const std::function<Outcome(Arguments...)>& callable,
                                 TermStore& store, std::span<const Term> arguments,
                                 std::index_sequence<kAt...> /*positions*/) {
  if (arguments.size() != sizeof...(Arguments)) {
    return failure("got " + std::to_string(arguments.size()) + " arguments, expected " +
                   std::to_string(sizeof...(Arguments)));
  }
  std::tuple<std::optional<std::remove_cvref_t<Arguments>>...> values;
  std::string wrong;
  if (!(... && read_argument(store, arguments, kAt, std::get<kAt>(values), wrong))) {
    return failure(std::move(wrong));
  }
  using Value = typename Unwrapped<Outcome>::Type;
  if constexpr (std::is_same_v<Value, Outcome>) {
    return HostValue<Value>::write(store, callable(std::move(*std::get<kAt>(values))...));
  } else {
    Outcome outcome = callable(std::move(*std::get<kAt>(values))...);
    if (!outcome) return tl::unexpected(std::move(outcome.error()));
    return HostValue<Value>::write(store, *outcome);
  }
}

template <class Outcome, class... Arguments>
TypedFunction make_typed(std::string name, std::function<Outcome(Arguments...)> callable) {
  TypedFunction made{name, sizeof...(Arguments), {}};
  made.function = [name = std::move(name), callable = std::move(callable)](
                      TermStore& store, std::span<const Term> arguments) {
    auto outcome = call_typed(callable, store, arguments, std::index_sequence_for<Arguments...>{});
    if (!outcome) outcome.error().why.insert(0, name + ": ");
    return outcome;
  };
  return made;
}

}  // namespace detail

/// Wraps a C++ callable (no overloads) whose arguments and result are types of HostValue; the
/// result may also be a Result of one. A term of the wrong type is a failure that names function,
/// argument and what was expected.
template <class Callable>
TypedFunction typed(std::string name, Callable callable) {
  return detail::make_typed(std::move(name), std::function(std::move(callable)));
}

}  // namespace skein::htn
