// SPDX-License-Identifier: Apache-2.0
// Functions of lists against the standard library, on drawn lists of few different items.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

#include "testing/lisp_fixture.hpp"

namespace skein::htn {
namespace {

using Items = std::vector<int>;

Items drawn_items() { return *rc::gen::container<Items>(rc::gen::inRange(0, 6)); }

/// As Lisp prints a list; of no items it is nil.
std::string shown(const Items& items) {
  std::string text;
  for (const int item : items) text += (text.empty() ? "" : " ") + std::to_string(item);
  return items.empty() ? "nil" : "(" + text + ")";
}
std::string quoted(const Items& items) { return " '" + shown(items) + " "; }

/// Items with their positions behind them, to tell equal ones apart: ((3 0) (1 1) …).
std::string placed(const Items& items) {
  std::string text;
  for (std::size_t at = 0; at < items.size(); ++at)
    text += "(" + std::to_string(items[at]) + " " + std::to_string(at) + ")";
  return "'(" + text + ")";
}

bool has(const Items& items, int item) {
  return std::find(items.begin(), items.end(), item) != items.end();
}

Items reversed(Items items) {
  std::reverse(items.begin(), items.end());
  return items;
}

struct Lisp : test::LispFixture {
  std::string of(const std::string& function, const std::string& arguments) {
    return value("(" + function + " " + arguments + ")");
  }
};

RC_GTEST_PROP(LispListProperty, AnItemIsFoundWhereTheLibraryFindsIt, ()) {
  const Items items = drawn_items();
  const int wanted = *rc::gen::inRange(0, 6);
  const std::string arguments = std::to_string(wanted) + " " + quoted(items);
  const auto at = std::find(items.begin(), items.end(), wanted);
  const auto last = std::find(items.rbegin(), items.rend(), wanted);
  const bool found = at != items.end();
  const auto place = [](auto distance) { return std::to_string(distance); };
  Lisp lisp;

  RC_ASSERT(lisp.of("member", arguments) == (found ? shown(Items(at, items.end())) : "nil"));
  RC_ASSERT(lisp.of("find", arguments) == (found ? std::to_string(wanted) : "nil"));
  RC_ASSERT(lisp.of("position", arguments) == (found ? place(at - items.begin()) : "nil"));
  RC_ASSERT(lisp.of("position", arguments + " :from-end t") ==
            (found ? place(items.rend() - last - 1) : "nil"));
  RC_ASSERT(lisp.of("count", arguments) ==
            std::to_string(std::count(items.begin(), items.end(), wanted)));
}

RC_GTEST_PROP(LispListProperty, FiltersKeepWhatTheLibraryKeeps, ()) {
  const Items items = drawn_items();
  const int wanted = *rc::gen::inRange(0, 6);
  Items without, even, odd;
  for (const int item : items) {
    if (item != wanted) without.push_back(item);
    (item % 2 == 0 ? even : odd).push_back(item);
  }
  Lisp lisp;

  RC_ASSERT(lisp.of("remove", std::to_string(wanted) + quoted(items)) == shown(without));
  RC_ASSERT(lisp.of("remove-if", "#'evenp " + quoted(items)) == shown(odd));
  RC_ASSERT(lisp.of("delete-if-not", "#'evenp " + quoted(items)) == shown(even));
  RC_ASSERT(lisp.of("count-if", "#'evenp " + quoted(items)) == std::to_string(even.size()));
  RC_ASSERT(lisp.of("find-if", "#'oddp " + quoted(items)) ==
            (odd.empty() ? "nil" : std::to_string(odd.front())));
  RC_ASSERT(lisp.of("find-if-not", "#'oddp " + quoted(items) + ":from-end t") ==
            (even.empty() ? "nil" : std::to_string(even.back())));
}

RC_GTEST_PROP(LispListProperty, OfDuplicatesOneStaysOnTheSideThatIsAskedFor, ()) {
  const Items items = drawn_items();
  Items first;
  for (const int item : items)
    if (!has(first, item)) first.push_back(item);
  Items last;
  for (const int item : reversed(items))
    if (!has(last, item)) last.push_back(item);
  Lisp lisp;

  RC_ASSERT(lisp.of("remove-duplicates", quoted(items)) == shown(reversed(last)));
  RC_ASSERT(lisp.of("delete-duplicates", quoted(items) + " :from-end t") == shown(first));
}

// SBCL walks the first list and puts what it selects in front of what it has.
RC_GTEST_PROP(LispListProperty, SetsAreSelectedInTheOrderOfSbcl, ()) {
  const Items left = drawn_items();
  const Items right = drawn_items();
  Items both, rest;
  for (const int item : left) (has(right, item) ? both : rest).push_back(item);
  const std::string arguments = quoted(left) + " " + quoted(right);
  Lisp lisp;

  RC_ASSERT(lisp.of("intersection", arguments) == shown(reversed(both)));
  RC_ASSERT(lisp.of("set-difference", arguments) == shown(right.empty() ? left : reversed(rest)));
  RC_ASSERT(lisp.of("subsetp", arguments) == (rest.empty() ? "t" : "nil"));
}

RC_GTEST_PROP(LispListProperty, AUnionIsTheShorterWithWhatTheLongerHasBeside, ()) {
  const Items left = drawn_items();
  const Items right = drawn_items();
  const Items& shorter = left.size() < right.size() ? left : right;
  const Items& longer = left.size() < right.size() ? right : left;
  Items expected = shorter;
  for (const int item : longer)
    if (!has(shorter, item)) expected.insert(expected.begin(), item);
  Lisp lisp;

  RC_ASSERT(lisp.of("union", quoted(left) + quoted(right)) == shown(expected));
}

RC_GTEST_PROP(LispListProperty, SortingKeepsTheOrderOfEqualKeys, ()) {
  const Items items = drawn_items();
  std::vector<std::size_t> order(items.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t left, std::size_t right) { return items[left] > items[right]; });
  Items places;
  for (const std::size_t at : order) places.push_back(static_cast<int>(at));
  Lisp lisp;

  RC_ASSERT(lisp.value("(mapcar #'second (sort " + placed(items) + " #'> :key #'first))") ==
            shown(places));
}

RC_GTEST_PROP(LispListProperty, ListsAreCutAndJoinedAtAnyPlace, ()) {
  const Items items = drawn_items();
  const auto at = *rc::gen::inRange<std::size_t>(0, 8);
  const std::size_t cut = std::min(at, items.size());
  const auto place = [&](std::size_t from) {
    return items.begin() + static_cast<std::ptrdiff_t>(from);
  };
  const std::size_t from_end = items.size() - cut;
  const std::string number = std::to_string(at);
  Lisp lisp;

  RC_ASSERT(lisp.of("nthcdr", number + quoted(items)) == shown(Items(place(cut), items.end())));
  RC_ASSERT(lisp.of("nth", number + quoted(items)) ==
            (at < items.size() ? std::to_string(items[at]) : "nil"));
  RC_ASSERT(lisp.of("last", quoted(items) + number) == shown(Items(place(from_end), items.end())));
  RC_ASSERT(lisp.of("butlast", quoted(items) + number) ==
            shown(Items(items.begin(), place(from_end))));
  RC_ASSERT(lisp.of("append", "(butlast " + quoted(items) + number + ") (last " + quoted(items) +
                                  number + ")") == shown(items));
  RC_ASSERT(lisp.of("reverse", quoted(items)) == shown(reversed(items)));
  RC_ASSERT(lisp.of("length", quoted(items)) == std::to_string(items.size()));
}

RC_GTEST_PROP(LispListProperty, AReductionGoesFromEitherSide, ()) {
  const Items items = drawn_items();
  const int start = *rc::gen::inRange(0, 6);
  int from_left = start;
  for (const int item : items) from_left -= item;
  int from_right = start;
  for (const int item : reversed(items)) from_right = item - from_right;
  const std::string rest = quoted(items) + " :initial-value " + std::to_string(start);
  Lisp lisp;

  RC_ASSERT(lisp.of("reduce", "#'- " + rest) == std::to_string(from_left));
  RC_ASSERT(lisp.of("reduce", "#'- " + rest + " :from-end t") == std::to_string(from_right));
}

RC_GTEST_PROP(LispListProperty, QuantifiersAreThoseOfTheLibrary, ()) {
  const Items items = drawn_items();
  const auto even = [](int item) { return item % 2 == 0; };
  const bool all = std::all_of(items.begin(), items.end(), even);
  const bool any = std::any_of(items.begin(), items.end(), even);
  const auto truth = [](bool value) { return std::string(value ? "t" : "nil"); };
  Lisp lisp;

  RC_ASSERT(lisp.of("every", "#'evenp " + quoted(items)) == truth(all));
  RC_ASSERT(lisp.of("notevery", "#'evenp " + quoted(items)) == truth(!all));
  RC_ASSERT(lisp.of("some", "#'evenp " + quoted(items)) == truth(any));
  RC_ASSERT(lisp.of("notany", "#'evenp " + quoted(items)) == truth(!any));
}

}  // namespace
}  // namespace skein::htn
