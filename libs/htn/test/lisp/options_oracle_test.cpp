// SPDX-License-Identifier: Apache-2.0
// Searches, filters and sets with drawn options (test, key, side) against loops over records.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "testing/lisp_fixture.hpp"

namespace skein::htn::lisp_options {
namespace {

/// (key value), keys and values from 0 to 5.
struct Record {
  int key = 0;
  int value = 0;
};
using Records = std::vector<Record>;
using Hits = std::vector<std::size_t>;

Records drawn_records() {
  Records records;
  for (auto left = *rc::gen::inRange(0, 8); left > 0; --left)
    records.push_back({*rc::gen::inRange(0, 6), *rc::gen::inRange(0, 6)});
  return records;
}

std::string shown(const Record& record) {
  return "(" + std::to_string(record.key) + " " + std::to_string(record.value) + ")";
}
std::string shown(const Records& records) {
  std::string text;
  for (const Record& record : records) text += (text.empty() ? "" : " ") + shown(record);
  return records.empty() ? "nil" : "(" + text + ")";
}
std::string quoted(const Records& records) { return " '" + shown(records) + " "; }
std::string shown(const std::optional<std::size_t>& place) {
  return place ? std::to_string(*place) : "nil";
}
std::string truth(bool value) { return value ? "t" : "nil"; }

/// A relation of two numbers that is not symmetric, or not transitive: the order of the arguments
/// and of the comparisons shows.
struct Relation {
  std::string text;
  std::function<bool(int, int)> holds;
};

Relation drawn_relation() {
  static const std::vector<Relation> kRelations{
      {"", [](int left, int right) { return left == right; }},
      {" :test #'<", [](int left, int right) { return left < right; }},
      {" :test #'>=", [](int left, int right) { return left >= right; }},
      {" :test-not #'<", [](int left, int right) { return left >= right; }},
      {" :test-not #'eql", [](int left, int right) { return left != right; }},
      {" :test (lambda (x y) (<= (abs (- x y)) 1))",
       [](int left, int right) { return std::abs(left - right) <= 1; }},
      {" :test (lambda (x y) (= x (1+ y)))", [](int left, int right) { return left == right + 1; }},
  };
  return kRelations[*rc::gen::inRange<std::size_t>(0, kRelations.size())];
}

/// What of a record is compared.
struct Key {
  std::string text;
  std::function<int(const Record&)> of;
};

Key drawn_key() {
  static const std::vector<Key> kKeys{
      {" :key #'first", [](const Record& record) { return record.key; }},
      {" :key #'second", [](const Record& record) { return record.value; }},
      {" :key (lambda (x) (- (first x) (second x)))",
       [](const Record& record) { return record.key - record.value; }},
  };
  return kKeys[*rc::gen::inRange<std::size_t>(0, kKeys.size())];
}

template <class Matches>
Hits hits(const Records& records, Matches matches) {
  Hits found;
  for (std::size_t at = 0; at < records.size(); ++at)
    if (matches(records[at])) found.push_back(at);
  return found;
}

std::optional<std::size_t> one_of(const Hits& found, bool from_end) {
  if (found.empty()) return std::nullopt;
  return from_end ? found.back() : found.front();
}

Records without(const Records& records, const Hits& removed) {
  Records kept;
  for (std::size_t at = 0; at < records.size(); ++at)
    if (std::find(removed.begin(), removed.end(), at) == removed.end()) kept.push_back(records[at]);
  return kept;
}

Records from(const Records& records, const std::optional<std::size_t>& place) {
  if (!place) return {};
  return {records.begin() + static_cast<std::ptrdiff_t>(*place), records.end()};
}

struct Lisp : test::LispFixture {
  std::string of(const std::string& function, const std::string& arguments) {
    RC_LOG() << "(" + function + " " + arguments + ")\n";
    return value("(" + function + " " + arguments + ")");
  }
};

// ---- searching ---------------------------------------------------------------------------------

RC_GTEST_PROP(LispOptions, SearchesForAnItemCompareItWithTheKeyOfEachRecord, ()) {
  const Records records = drawn_records();
  const Relation relation = drawn_relation();
  const Key key = drawn_key();
  const int item = *rc::gen::inRange(-2, 6);
  const Hits found =
      hits(records, [&](const Record& record) { return relation.holds(item, key.of(record)); });
  const std::string arguments = std::to_string(item) + quoted(records) + relation.text + key.text;
  const bool from_end = *rc::gen::arbitrary<bool>();
  const std::string side = from_end ? " :from-end t" : "";
  const std::optional<std::size_t> place = one_of(found, from_end);
  Lisp lisp;

  RC_ASSERT(lisp.of("position", arguments + side) == shown(place));
  RC_ASSERT(lisp.of("find", arguments + side) == (place ? shown(records[*place]) : "nil"));
  RC_ASSERT(lisp.of("member", arguments) == shown(from(records, one_of(found, false))));
  RC_ASSERT(lisp.of("count", arguments + side) == std::to_string(found.size()));
  RC_ASSERT(lisp.of("remove", arguments + side) == shown(without(records, found)));
  RC_ASSERT(lisp.of("delete", arguments) == shown(without(records, found)));
}

RC_GTEST_PROP(LispOptions, SearchesByAPredicateAskItForTheKeyOfEachRecord, ()) {
  const Records records = drawn_records();
  const Key key = drawn_key();
  const auto odd = [&](const Record& record) { return key.of(record) % 2 != 0; };
  const Hits odds = hits(records, odd);
  const Hits evens = hits(records, [&](const Record& record) { return !odd(record); });
  const bool from_end = *rc::gen::arbitrary<bool>();
  const std::string rest = "#'oddp" + quoted(records) + key.text;
  const std::string sided = rest + (from_end ? " :from-end t" : " :from-end nil");
  Lisp lisp;

  RC_ASSERT(lisp.of("position-if", sided) == shown(one_of(odds, from_end)));
  RC_ASSERT(lisp.of("position-if-not", sided) == shown(one_of(evens, from_end)));
  RC_ASSERT(lisp.of("member-if", rest) == shown(from(records, one_of(odds, false))));
  RC_ASSERT(lisp.of("count-if", sided) == std::to_string(odds.size()));
  RC_ASSERT(lisp.of("count-if-not", sided) == std::to_string(evens.size()));
  RC_ASSERT(lisp.of("remove-if", sided) == shown(without(records, odds)));
  RC_ASSERT(lisp.of("remove-if-not", sided) == shown(without(records, evens)));
  RC_ASSERT(lisp.of("delete-if", rest) == shown(without(records, odds)));
  RC_ASSERT(lisp.of("delete-if-not", rest) == shown(without(records, evens)));
}

RC_GTEST_PROP(LispOptions, AssociationsAreFoundByTheirFirstOrByTheirRest, ()) {
  const Records records = drawn_records();
  const Relation relation = drawn_relation();
  const int item = *rc::gen::inRange(0, 6);
  std::string pairs;  // ((key . value) nil …): nil among them is passed over
  for (const Record& record : records)
    pairs += "(" + std::to_string(record.key) + " . " + std::to_string(record.value) + ") nil ";
  const std::string arguments = std::to_string(item) + " '(" + pairs + ")" + relation.text;
  const auto expected = [&](auto part) -> std::string {
    for (const Record& record : records)
      if (relation.holds(item, part(record)))
        return "(" + std::to_string(record.key) + " . " + std::to_string(record.value) + ")";
    return "nil";
  };
  Lisp lisp;

  RC_ASSERT(lisp.of("assoc", arguments) == expected([](const Record& one) { return one.key; }));
  RC_ASSERT(lisp.of("rassoc", arguments) == expected([](const Record& one) { return one.value; }));
  RC_ASSERT(lisp.of("assoc", arguments + " :key #'1-") ==
            expected([](const Record& one) { return one.key - 1; }));
}

// ---- duplicates and sets -----------------------------------------------------------------------

// CLHS: items are compared pairwise, and of two that match the earlier one is discarded, whether or
// not the later one is discarded too.
RC_GTEST_PROP(LispOptions, AnItemIsADuplicateIfItMatchesAnyThatFollows, ()) {
  const Records records = drawn_records();
  const Relation relation = drawn_relation();
  const Key key = drawn_key();
  Records kept;
  for (auto one = records.begin(); one != records.end(); ++one) {
    const bool again = std::any_of(one + 1, records.end(), [&](const Record& later) {
      return relation.holds(key.of(*one), key.of(later));
    });
    if (!again) kept.push_back(*one);
  }
  const std::string arguments = quoted(records) + relation.text + key.text;
  Lisp lisp;

  RC_ASSERT(lisp.of("remove-duplicates", arguments) == shown(kept));
  RC_ASSERT(lisp.of("delete-duplicates", arguments) == shown(kept));
}

TEST(LispOptionsOfDuplicates, FromTheEndThoseThatStayAreComparedOnly) {
  Lisp lisp;
  const std::string near = "'(1 2 3 4 5) :test (lambda (x y) (<= (abs (- x y)) 1))";

  EXPECT_EQ(lisp.value("(remove-duplicates " + near + ")"), "(5)");
  EXPECT_EQ(lisp.value("(remove-duplicates " + near + " :from-end t)"), "(1 3 5)");
}

bool in(const Record& one, const Records& others, const Relation& relation, const Key& key) {
  return std::any_of(others.begin(), others.end(), [&](const Record& other) {
    return relation.holds(key.of(one), key.of(other));
  });
}

// SBCL pushes each record of one list that it selects on what it has.
RC_GTEST_PROP(LispOptions, SetsTakeTheTestWithTheRecordOfTheListThatIsWalkedFirst, ()) {
  const Records left = drawn_records();
  const Records right = drawn_records();
  const Relation relation = drawn_relation();
  const Key key = drawn_key();
  Records both, rest;
  for (const Record& one : left) {
    Records& side = in(one, right, relation, key) ? both : rest;
    side.insert(side.begin(), one);
  }
  const bool left_is_shorter = left.size() < right.size();
  Records united = left_is_shorter ? left : right;
  for (const Record& one : left_is_shorter ? right : left)
    if (!in(one, left_is_shorter ? left : right, relation, key)) united.insert(united.begin(), one);
  const std::string arguments = quoted(left) + quoted(right) + relation.text + key.text;
  Lisp lisp;

  RC_ASSERT(lisp.of("intersection", arguments) == shown(both));
  RC_ASSERT(lisp.of("set-difference", arguments) == shown(right.empty() ? left : rest));
  RC_ASSERT(lisp.of("subsetp", arguments) == truth(rest.empty()));
  RC_ASSERT(lisp.of("union", arguments) == shown(united));
}

RC_GTEST_PROP(LispOptions, ARecordJoinsASetThatHasNoneLikeIt, ()) {
  const Records records = drawn_records();
  const Relation relation = drawn_relation();
  const Key key = drawn_key();
  const Record one{*rc::gen::inRange(0, 6), *rc::gen::inRange(0, 6)};
  Records joined = records;
  if (!in(one, records, relation, key)) joined.insert(joined.begin(), one);
  Lisp lisp;

  RC_ASSERT(lisp.of("adjoin", "'" + shown(one) + quoted(records) + relation.text + key.text) ==
            shown(joined));
}

// ---- rows and folds ----------------------------------------------------------------------------

RC_GTEST_PROP(LispOptions, FoldsTakeTheKeysOfTheRecordsFromTheSideAsked, ()) {
  const Records records = drawn_records();
  const Key key = drawn_key();
  std::vector<std::int64_t> keys;
  for (const Record& record : records) keys.push_back(key.of(record));
  const bool from_end = *rc::gen::arbitrary<bool>();
  const bool started = records.empty() || *rc::gen::arbitrary<bool>();
  if (started) keys.insert(from_end ? keys.end() : keys.begin(), 7);
  if (from_end) std::reverse(keys.begin(), keys.end());
  std::int64_t folded = keys.front();
  for (std::size_t at = 1; at < keys.size(); ++at)
    folded = from_end ? 2 * keys[at] - folded : 2 * folded - keys[at];
  const std::string arguments = "(lambda (x y) (- (* 2 x) y))" + quoted(records) + key.text +
                                (from_end ? " :from-end t" : "") +
                                (started ? " :initial-value 7" : "");
  Lisp lisp;

  RC_ASSERT(lisp.of("reduce", arguments) == std::to_string(folded));
}

RC_GTEST_PROP(LispOptions, RowsOfListsEndWithTheShortest, ()) {
  const Records left = drawn_records();
  const Records right = drawn_records();
  const std::size_t rows = std::min(left.size(), right.size());
  std::string differences, joined;
  bool all = true, any = false;
  for (std::size_t row = 0; row < rows; ++row) {
    const int difference = left[row].key - right[row].value;
    differences += (row == 0 ? "" : " ") + std::to_string(difference);
    if (difference > 0) joined += (joined.empty() ? "" : " ") + shown(left[row]);
    all = all && difference > 0;
    any = any || difference > 0;
  }
  const auto list = [](const std::string& text) { return text.empty() ? "nil" : "(" + text + ")"; };
  const std::string lists = quoted(left) + quoted(right);
  const std::string greater = "(lambda (x y) (> (first x) (second y)))" + lists;
  Lisp lisp;

  RC_ASSERT(lisp.of("mapcar", "(lambda (x y) (- (first x) (second y)))" + lists) ==
            list(differences));
  RC_ASSERT(lisp.of("mapcan", "(lambda (x y) (if (> (first x) (second y)) (list x)))" + lists) ==
            list(joined));
  RC_ASSERT(lisp.of("mapc", greater) == shown(left));
  RC_ASSERT(lisp.of("every", greater) == truth(all));
  RC_ASSERT(lisp.of("some", greater) == truth(any));
  RC_ASSERT(lisp.of("notevery", greater) == truth(!all));
  RC_ASSERT(lisp.of("notany", greater) == truth(!any));
}

RC_GTEST_PROP(LispOptions, RecordsAreSortedByTheirKeysAndEqualOnesStayInOrder, ()) {
  const Records records = drawn_records();
  const Key key = drawn_key();
  Records sorted = records;
  const bool falling = *rc::gen::arbitrary<bool>();
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Record& left, const Record& right) {
    return falling ? key.of(left) > key.of(right) : key.of(left) < key.of(right);
  });
  Lisp lisp;

  RC_ASSERT(lisp.of("sort", quoted(records) + (falling ? "#'>" : "#'<") + key.text) ==
            shown(sorted));
}

}  // namespace
}  // namespace skein::htn::lisp_options
