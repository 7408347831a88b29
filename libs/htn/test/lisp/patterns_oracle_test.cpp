// SPDX-License-Identifier: Apache-2.0
// Drawn patterns and values: what destructuring-bind binds and refuses, what a backquote makes of
// them, and that data is written as it is read.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <optional>

#include "testing/lisp_fixture.hpp"

namespace skein::htn::patterns {
namespace {

/// An atom, or a list whose last tail is an atom if it has one.
struct Data {
  std::string atom = {};  ///< empty: a list
  std::vector<Data> items = {};
  std::string tail = {};  ///< empty: a proper list

  bool is_list() const { return atom.empty(); }
};

Data drawn_data(int depth) {
  if (depth == 0 || *rc::gen::inRange(0, 3) == 0)
    return {*rc::gen::element<std::string>("a", "b", "7", "-1/2", "2.5", "\"x y\"", "\"q\\\"\\\\\"",
                                           ":key", "t", "?free")};
  Data list;
  for (int left = *rc::gen::inRange(0, 5); left > 0; --left)
    list.items.push_back(drawn_data(depth - 1));
  if (!list.items.empty() && *rc::gen::inRange(0, 4) == 0) list.tail = "z";
  return list;
}

std::string shown(const Data& data) {
  if (!data.is_list()) return data.atom;
  if (data.items.empty()) return "nil";
  std::string text;
  for (const Data& item : data.items) text += (text.empty() ? "" : " ") + shown(item);
  return "(" + text + (data.tail.empty() ? "" : " . " + data.tail) + ")";
}

/// What is left of a list after some of its items.
Data rest_of(const Data& list, std::size_t from) {
  if (from == list.items.size()) return list.tail.empty() ? Data{} : Data{list.tail};
  Data rest = list;
  rest.items.erase(rest.items.begin(), rest.items.begin() + static_cast<std::ptrdiff_t>(from));
  return rest;
}

/// A variable; or parts, at least one, then optional variables whose default is `none`, then one
/// for the rest.
struct Pattern {
  std::string variable = {};
  std::vector<Pattern> parts = {};
  std::vector<std::string> optional = {};
  std::string rest = {};
  bool dotted = false;
};

class PatternDrawing {
 public:
  std::vector<std::string> variables;

  Pattern drawn(int depth, bool whole = true) {
    if (!whole && (depth == 0 || *rc::gen::arbitrary<bool>())) return {fresh()};
    Pattern pattern;
    for (int left = *rc::gen::inRange(1, 4); left > 0; --left)
      pattern.parts.push_back(drawn(depth - 1, false));
    for (int left = std::max(0, *rc::gen::inRange(-2, 3)); left > 0; --left)
      pattern.optional.push_back(fresh());
    if (*rc::gen::arbitrary<bool>()) pattern.rest = fresh();
    pattern.dotted =
        !pattern.rest.empty() && pattern.optional.empty() && *rc::gen::arbitrary<bool>();
    return pattern;
  }

 private:
  std::string fresh() {
    variables.push_back("v" + std::to_string(variables.size()));
    return variables.back();
  }
};

std::string shown(const Pattern& pattern) {
  if (!pattern.variable.empty()) return pattern.variable;
  std::string text;
  for (const Pattern& part : pattern.parts) text += (text.empty() ? "" : " ") + shown(part);
  if (!pattern.optional.empty()) text += " &optional";
  for (const std::string& one : pattern.optional) text += " (" + one + " 'none)";
  if (!pattern.rest.empty()) text += (pattern.dotted ? " . " : " &rest ") + pattern.rest;
  return "(" + text + ")";
}

using Values = std::map<std::string, std::string>;

/// Nothing where the list is too short or too long for the pattern.
bool bind(const Pattern& pattern, const Data& data, Values& values) {
  if (!pattern.variable.empty()) {
    values[pattern.variable] = shown(data);
    return true;
  }
  const Data list = data.is_list() ? data : Data{};
  if (!data.is_list()) return false;
  std::size_t at = 0;
  for (const Pattern& part : pattern.parts) {
    if (at == list.items.size() || !bind(part, list.items[at], values)) return false;
    ++at;
  }
  for (const std::string& variable : pattern.optional) {
    if (at == list.items.size() && !list.tail.empty()) return false;  // a tail is no end
    values[variable] = at < list.items.size() ? shown(list.items[at++]) : "none";
  }
  if (!pattern.rest.empty()) {
    values[pattern.rest] = shown(rest_of(list, at));
    return true;
  }
  return at == list.items.size() && list.tail.empty();
}

RC_GTEST_PROP(LispPatterns, BindWhatStandsInTheirPlaces, ()) {
  PatternDrawing drawing;
  const Pattern pattern = drawing.drawn(2);
  const Data data = drawn_data(3);
  Values values;
  const bool fits = bind(pattern, data, values);
  std::string variables, expected;
  for (const std::string& variable : drawing.variables) {
    variables += " " + variable;
    expected += (expected.empty() ? "" : " ") + values[variable];
  }
  test::LispFixture lisp;
  const std::string form =
      "(destructuring-bind " + shown(pattern) + " '" + shown(data) + " (list" + variables + "))";
  const std::string value = lisp.value(form);
  RC_LOG() << form << "\n" << value << "\n";

  if (fits)
    RC_ASSERT(value == "(" + expected + ")");
  else
    RC_ASSERT(value.starts_with("error: "));
}

RC_GTEST_PROP(LispPatterns, DataIsWrittenAsItIsRead, ()) {
  const std::string text = shown(drawn_data(4));
  test::LispFixture lisp;

  RC_ASSERT(lisp.value("'" + text) == text);
  RC_ASSERT(lisp.value("`" + text) == text);
  RC_ASSERT(lisp.value("(copy-tree '" + text + ")") == text);
  RC_ASSERT(lisp.value("(equal '" + text + " (car (list '" + text + ")))") == "t");
}

/// A template with holes: its text, and what it becomes when x is a list and y an atom.
struct Template {
  std::string text, value;
};

Template drawn_template(const Data& list, int depth) {
  std::string text, value;
  for (int left = *rc::gen::inRange(1, 5); left > 0; --left) {
    std::string item, becomes;
    switch (*rc::gen::inRange(0, depth == 0 ? 4 : 5)) {
      case 0:
        item = becomes = shown(drawn_data(1));
        break;
      case 1:
        item = ",y";
        becomes = "atom";
        break;
      case 2:
        item = ",x";
        becomes = shown(list);
        break;
      case 3:
        item = ",@x";
        for (const Data& one : list.items) becomes += (becomes.empty() ? "" : " ") + shown(one);
        break;
      default:
        const Template inner = drawn_template(list, depth - 1);
        item = inner.text;
        becomes = inner.value;
    }
    text += (text.empty() ? "" : " ") + item;
    if (!becomes.empty()) value += (value.empty() ? "" : " ") + becomes;
  }
  return {"(" + text + ")", value.empty() ? "nil" : "(" + value + ")"};
}

RC_GTEST_PROP(LispPatterns, TemplatesAreFilledAtTheirCommasOnly, ()) {
  Data list;
  for (int left = *rc::gen::inRange(0, 4); left > 0; --left) list.items.push_back(drawn_data(1));
  const Template made = drawn_template(list, 2);
  test::LispFixture lisp;
  const std::string form = "(let ((x '" + shown(list) + ") (y 'atom)) `" + made.text + ")";
  RC_LOG() << form << "\n";

  RC_ASSERT(lisp.value(form) == made.value);
}

RC_GTEST_PROP(LispPatterns, ListsAreTakenApartByAnyPathOfFirstsAndRests, ()) {
  Data data;
  for (int left = *rc::gen::inRange(0, 5); left > 0; --left) data.items.push_back(drawn_data(3));
  std::string form = "'" + shown(data);
  std::optional<Data> at = data;
  for (int left = *rc::gen::inRange(1, 5); left > 0 && at; --left) {
    const bool first = *rc::gen::arbitrary<bool>();
    form = std::string(first ? "(car " : "(cdr ") + form + ")";
    if (!at->is_list()) {
      at.reset();
    } else if (!at->items.empty()) {
      at = first ? at->items.front() : rest_of(*at, 1);
    }
  }
  test::LispFixture lisp;
  RC_LOG() << form << "\n";

  if (at)
    RC_ASSERT(lisp.value(form) == shown(*at));
  else
    RC_ASSERT(lisp.value(form).starts_with("error: "));
}

}  // namespace
}  // namespace skein::htn::patterns
