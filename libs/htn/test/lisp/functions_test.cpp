// SPDX-License-Identifier: Apache-2.0
#include "skein/htn/functions.hpp"

#include <gtest/gtest.h>

#include "skein/htn/typed_function.hpp"
#include "testing/lisp_fixture.hpp"

namespace skein::htn {

struct Route {
  std::vector<double> points;
};

template <>
struct ObjectName<Route> {
  static constexpr std::string_view kValue = "path";
};

namespace {

using RoutePointer = std::shared_ptr<const Route>;

class HostFunctions : public ::testing::Test, protected test::LispFixture {};

TEST_F(HostFunctions, AreFoundInAnyCase) {
  functions.add("Double-It", 1, 1, [](TermStore& terms, std::span<const Term> arguments) {
    return Result<Term, Failure>(terms.pair(arguments[0], arguments[0]));
  });
  restart();

  EXPECT_NE(functions.find("DOUBLE-it"), nullptr);
  EXPECT_EQ(functions.find("double"), nullptr);
  EXPECT_EQ(value("(double-it 'a)"), "(a . a)");
}

TEST_F(HostFunctions, ArgumentCountsAreCheckedWhenLoading) {
  functions.add(typed("half", [](double x) { return x / 2; }));
  restart();

  EXPECT_EQ(value("(half)"), "load: test.lisp:1:2: 'half' with no arguments; expected 1 argument");
  EXPECT_EQ(value("(half 1 2)"),
            "load: test.lisp:1:2: 'half' with 2 arguments; expected 1 argument");
  EXPECT_EQ(value("(apply 'half '(1 2))"), "error: 'apply': 'half' takes 1 argument");
}

TEST_F(HostFunctions, ConvertArgumentsAndResultsByTheirTypes) {
  functions.add(typed("distance", [](double x, double y) { return std::hypot(x, y); }));
  functions.add(typed("twice", [](std::int64_t x) { return 2 * x; }));
  functions.add(typed("greet", [](const std::string& name) { return "hello " + name; }));
  functions.add(typed("total", [](const std::vector<double>& all) {
    double sum = 0;
    for (const double each : all) sum += each;
    return sum;
  }));
  functions.add(typed("same", [](Term left, Term right) { return left == right; }));
  functions.add(typed("doubled", [](std::vector<Term> all) {
    std::vector<Term> out = all;
    out.insert(out.end(), all.begin(), all.end());
    return out;
  }));
  restart();

  EXPECT_EQ(value("(distance 3 4.0)"), "5.0");
  EXPECT_EQ(value("(twice 21)"), "42");
  EXPECT_EQ(value("(greet 'karma)"), "\"hello karma\"");
  EXPECT_EQ(value("(greet \"Karma\")"), "\"hello Karma\"");
  EXPECT_EQ(value("(total '(1 1/2 0.5d0))"), "2.0");
  EXPECT_EQ(value("(total ())"), "0.0");
  EXPECT_EQ(value("(same '(a b) (list 'a 'b))"), "t");
  EXPECT_EQ(value("(doubled '(a (b)))"), "(a (b) a (b))");
}

TEST_F(HostFunctions, WrongTypesNameFunctionArgumentAndWhatWasExpected) {
  functions.add(typed("distance", [](double x, double y) { return x + y; }));
  functions.add(typed("twice", [](std::int64_t x) { return 2 * x; }));
  functions.add(typed("total", [](const std::vector<double>& all) { return all.size() > 1; }));
  functions.add(typed("size", [](const RoutePointer& path) { return path != nullptr; }));
  restart();

  EXPECT_EQ(value("(distance 1 '(a b))"),
            "error: distance: argument 2 is (a b), expected a number");
  EXPECT_EQ(value("(twice 1.5)"), "error: twice: argument 1 is 1.5, expected an integer");
  EXPECT_EQ(value("(total '(1 b))"),
            "error: total: argument 1 is (1 b), expected a list, each item a number");
  EXPECT_EQ(value("(total '(1 . 2))"),
            "error: total: argument 1 is (1 . 2), expected a list, each item a number");
  EXPECT_EQ(value("(size 5)"), "error: size: argument 1 is 5, expected #<path>");
}

TEST_F(HostFunctions, FailuresAreErrorsWithTheirReasonAndThePlaceOfTheCall) {
  functions.add(typed("route", [](double length) -> Result<double, Failure> {
    if (length > 10) return failure("no path is that long");
    return length;
  }));
  restart();
  const Expression text = read("(+ 1\n   (route 11))");
  Diagnostics errors;

  const CodeIndex code = lisp().compile(text, slot_of(), errors);
  const auto result = evaluated(code);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().why, "route: no path is that long");
  EXPECT_EQ(place_of(*text.document, (*result.error().where).begin).line, 2);
  EXPECT_EQ(value("(route 10)"), "10.0");
}

TEST_F(HostFunctions, NumbersThatAreNotFiniteAreFailures) {
  functions.add(typed("nothing", [] { return std::nan(""); }));
  restart();

  EXPECT_EQ(value("(nothing)"), "error: nothing: the result is not a finite number");
}

TEST_F(HostFunctions, ObjectsArePassedOnByLaterTerms) {
  functions.add(typed("plan-path", [](double from, double to) -> RoutePointer {
    if (from == to) return nullptr;
    return std::make_shared<const Route>(Route{{from, (from + to) / 2, to}});
  }));
  functions.add(typed("path-size", [](RoutePointer path) {
    return static_cast<std::int64_t>(path->points.size());
  }));
  functions.add(typed("path-end", [](const RoutePointer& path) { return path->points.back(); }));
  restart();
  set("?path", *evaluated([&] {
        Diagnostics errors;
        return lisp().compile(read("(plan-path 1 9)"), slot_of(), errors);
      }()));

  EXPECT_EQ(value("?path"), "#<path>");
  EXPECT_EQ(value("(path-size ?path)"), "3");
  EXPECT_EQ(value("(list (path-end '?path) (path-end (second (list 'x ?path))))"), "(9.0 9.0)");
  EXPECT_EQ(task("(!fly ?path (call path-size ?path))"), "(!fly #<path> 3)");
  EXPECT_EQ(value("(plan-path 1 1)"), "nil");
}

TEST_F(HostFunctions, AnObjectOfAnotherTypeIsAWrongArgument) {
  functions.add(typed("make-other", [] { return std::make_shared<const int>(1); }));
  functions.add(typed("path-size", [](RoutePointer path) { return path == nullptr; }));
  restart();

  EXPECT_EQ(value("(path-size (make-other))"),
            "error: path-size: argument 1 is #<host object>, expected #<path>");
}

TEST_F(HostFunctions, BuiltInFunctionsComeFirst) {
  functions.add(typed("car", [](Term) { return true; }));
  define("(defun route (x) 'defined)");
  functions.add(typed("route", [](Term) { return std::string("host"); }));
  restart();

  EXPECT_EQ(value("(car '(a))"), "a");
  EXPECT_EQ(value("(route 1)"), "\"host\"");
}

TEST_F(HostFunctions, AreFunctionValuesToo) {
  functions.add(typed("twice", [](std::int64_t x) { return 2 * x; }));
  restart();

  EXPECT_EQ(value("(mapcar #'twice '(1 2))"), "(2 4)");
  EXPECT_EQ(apply("#'twice", {"4"}), "8");
}

TEST(Functions, NamesAreInAlphabeticalOrder) {
  Functions functions;
  functions.add(typed("b", [] { return true; }));
  functions.add(typed("A", [] { return true; }));

  EXPECT_EQ(functions.names(), (std::vector<std::string>{"a", "b"}));
}

}  // namespace
}  // namespace skein::htn
