// SPDX-License-Identifier: Apache-2.0
// Random expressions: against the arithmetic of C++, and for crashes.
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <optional>

#include "lisp/builtins.hpp"
#include "skein/foundation/random.hpp"
#include "testing/lisp_fixture.hpp"

namespace skein::htn {
namespace {

// An expression of integers and its value in C++; nothing when it overflows.
struct Known {
  std::string text;
  std::optional<std::int64_t> value;
};

class Generator {
 public:
  explicit Generator(std::uint64_t seed) : random_(seed) {}

  Known integer_expression(int depth) {
    if (depth == 0 || pick(4) == 0) {
      const auto value = static_cast<std::int64_t>(pick(2000)) - 1000;
      return {std::to_string(value), value};
    }
    const Known left = integer_expression(depth - 1);
    const Known right = integer_expression(depth - 1);
    switch (pick(6)) {
      case 0:
        return both("+", left, right,
                    [](auto a, auto b, auto* out) { return __builtin_add_overflow(a, b, out); });
      case 1:
        return both("-", left, right,
                    [](auto a, auto b, auto* out) { return __builtin_sub_overflow(a, b, out); });
      case 2:
        return both("*", left, right,
                    [](auto a, auto b, auto* out) { return __builtin_mul_overflow(a, b, out); });
      case 3:
        return both("max", left, right, [](auto a, auto b, auto* out) {
          *out = std::max(a, b);
          return false;
        });
      case 4:
        return both("(lambda (x y) (if (< x y) x y))", left, right, [](auto a, auto b, auto* out) {
          *out = std::min(a, b);
          return false;
        });
      default:
        return both("mod", left, right, [](auto a, auto b, auto* out) {
          if (b == 0) return true;
          *out = b == -1 ? 0 : a % b;
          if (*out != 0 && (*out < 0) != (b < 0)) *out += b;
          return false;
        });
    }
  }

  /// Any nesting of functions, forms and data, mostly wrong.
  std::string anything(int depth) {
    if (depth == 0 || pick(5) == 0) return kAtoms[pick(kAtoms.size())];
    const std::string head = pick(3) == 0 ? kForms[pick(kForms.size())] : function_name();
    std::string text = "(" + head;
    for (std::size_t count = pick(4); count > 0; --count) text += ' ' + anything(depth - 1);
    return text + ')';
  }

 private:
  template <class Operation>
  static Known both(const std::string& head, const Known& left, const Known& right,
                    Operation operation) {
    Known made{"(" + head + ' ' + left.text + ' ' + right.text + ')', std::nullopt};
    std::int64_t result = 0;
    if (left.value && right.value && !operation(*left.value, *right.value, &result)) {
      made.value = result;
    }
    return made;
  }
  std::size_t pick(std::size_t count) { return random_.below(count); }
  std::string function_name() {
    const auto tables = lisp::all_builtins();
    const auto table = tables[pick(tables.size())];
    return std::string(table[pick(table.size())].name);
  }

  const std::vector<std::string> kAtoms{"1",
                                        "-2",
                                        "0",
                                        "1/3",
                                        "2.5",
                                        "1d0",
                                        "a",
                                        "nil",
                                        "t",
                                        "?x",
                                        "'?list",
                                        "'(1 2 3)",
                                        "'(a . b)",
                                        "\"s\"",
                                        "#'car",
                                        "#'+",
                                        "#'<",
                                        ":key",
                                        ":test",
                                        "()",
                                        "'(a (b c))",
                                        "x",
                                        "9223372036854775807",
                                        "?free",
                                        "1e30",
                                        "-0.0",
                                        "#'list",
                                        "'?x",
                                        "'(lambda (x) x)"};
  const std::vector<std::string> kForms{"if",
                                        "cond",
                                        "let ((x 1))",
                                        "let* ((x 1) (y x))",
                                        "lambda (x)",
                                        "progn",
                                        "and",
                                        "or",
                                        "when",
                                        "unless",
                                        "quote",
                                        "dolist (x '(1 2))",
                                        "dotimes (x 3)",
                                        "case",
                                        "setq x",
                                        "incf x",
                                        "push",
                                        "pop",
                                        "block nil",
                                        "return",
                                        "funcall",
                                        "(lambda (x &optional y &rest z) x)",
                                        "destructuring-bind (x . y)",
                                        "call",
                                        "eval",
                                        "backquote",
                                        "comma",
                                        "comma-at"};
  Random random_;
};

RC_GTEST_PROP(LispProperties, IntegerExpressionsHaveTheValueOfCpp, ()) {
  test::LispFixture lisp;
  Generator generator(*rc::gen::arbitrary<std::uint64_t>());
  const Known known = generator.integer_expression(5);

  const std::string value = lisp.value(known.text);

  if (known.value) {
    RC_ASSERT(value == std::to_string(*known.value));
  } else {
    RC_ASSERT(value.starts_with("error: "));
  }
}

RC_GTEST_PROP(LispProperties, AnyExpressionIsAValueOrAnError, ()) {
  test::LispFixture lisp;
  lisp.set("?x", "5");
  lisp.set("?list", "(1 b (c))");
  lisp.set("?free", Term(TermKind::kVariable, 3));
  lisp.lisp().limit_steps(20'000);
  Generator generator(*rc::gen::arbitrary<std::uint64_t>());

  for (int round = 0; round < 20; ++round) {
    const std::string text = generator.anything(4);
    const std::string first = lisp.value(text);
    const std::string second = lisp.value(text);
    RC_ASSERT(!first.empty());
    RC_ASSERT(first == second);
  }
}

RC_GTEST_PROP(LispProperties, SortingGivesTheListsOfTheStandardLibrary,
              (std::vector<std::int16_t> numbers)) {
  test::LispFixture lisp;
  std::vector<Term> terms;
  for (const std::int16_t number : numbers) terms.push_back(lisp.store.integer(number));
  lisp.set("?numbers", lisp.store.list(terms));
  std::stable_sort(numbers.begin(), numbers.end(),
                   [](int left, int right) { return left % 10 < right % 10; });
  terms.clear();
  for (const std::int16_t number : numbers) terms.push_back(lisp.store.integer(number));

  const std::string sorted =
      lisp.value("(stable-sort ?numbers (lambda (x y) (< (rem x 10) (rem y 10))))");

  RC_ASSERT(sorted == lisp.store.to_text(lisp.store.list(terms)));
}

}  // namespace
}  // namespace skein::htn
