// SPDX-License-Identifier: Apache-2.0
// Laws of edits of values: what undoes what, and what one edit is made of.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "skein/foundation/random.hpp"
#include "skein/yaml_edit/edit.hpp"

namespace skein::yaml_edit {
namespace {

using config::Value;

Value scalar_of(const std::string& text) {
  Value value;
  value.kind = Value::Kind::kScalar;
  value.scalar = text;
  return value;
}

Value any_value(Random& random, int depth) {
  Value value;
  const std::uint64_t kind = depth == 0 ? 0 : random.below(3);
  if (kind == 0) return scalar_of(std::to_string(random.below(100)));
  value.kind = kind == 1 ? Value::Kind::kSequence : Value::Kind::kMap;
  const std::uint64_t count = random.below(4);
  for (std::uint64_t i = 0; i < count; ++i) {
    if (kind == 1) value.items.push_back(any_value(random, depth - 1));
    if (kind == 2)
      value.entries.push_back({std::string(1, "abcd"[i]), any_value(random, depth - 1)});
  }
  return value;
}

/// Where each value of a document is, the document itself not.
void collect(const Value& value, const Path& at, std::vector<Path>& all) {
  const auto below = [&](Step step, const Value& inner) {
    Path path = at;
    path.push_back(std::move(step));
    all.push_back(path);
    collect(inner, path, all);
  };
  for (std::size_t i = 0; i < value.items.size(); ++i) below(i, value.items[i]);
  for (const config::Entry& entry : value.entries) below(entry.key, entry.value);
}

std::vector<Path> places_in(const Value& document) {
  std::vector<Path> all;
  collect(document, {}, all);
  return all;
}

const Value& value_at(const Value& document, const Path& path) {
  const Value* value = &document;
  for (const Step& step : path) {
    const auto* key = std::get_if<std::string>(&step);
    value = key != nullptr ? value->find(*key) : &value->items.at(std::get<std::size_t>(step));
  }
  return *value;
}

Path around(Path path) {
  path.pop_back();
  return path;
}
bool is_item(const Path& path) { return std::holds_alternative<std::size_t>(path.back()); }

/// Calls with documents and each place in them.
template <class Check>
void for_places(std::uint64_t seed, Check check) {
  Random random(seed);
  for (int trial = 0; trial < 150; ++trial) {
    const Value document = any_value(random, 3);
    for (const Path& path : places_in(document)) check(document, path);
  }
}

/// Order counts too.
bool identical(const Value& a, const Value& b) {
  if (!says_same(a, b)) return false;
  for (std::size_t i = 0; i < a.items.size(); ++i)
    if (!identical(a.items[i], b.items[i])) return false;
  for (std::size_t i = 0; i < a.entries.size(); ++i) {
    if (a.entries[i].key != b.entries[i].key) return false;
    if (!identical(a.entries[i].value, b.entries[i].value)) return false;
  }
  return true;
}

TEST(AppliedLaws, WhatIsSetIsThereAndSettingItBackUndoesIt) {
  for_places(1, [](const Value& document, const Path& path) {
    const auto set = applied(document, Set{path, scalar_of("new")});
    ASSERT_TRUE(set.has_value()) << to_text(path);
    EXPECT_TRUE(identical(value_at(*set, path), scalar_of("new")));

    const auto back = applied(*set, Set{path, value_at(document, path)});
    ASSERT_TRUE(back.has_value());
    EXPECT_TRUE(identical(*back, document)) << to_text(path);
  });
}

TEST(AppliedLaws, WhatIsRemovedComesBackByInsertingIt) {
  for_places(2, [](const Value& document, const Path& path) {
    const auto without = applied(document, Remove{path});
    ASSERT_TRUE(without.has_value()) << to_text(path);
    EXPECT_FALSE(identical(*without, document));

    Insert insert{around(path), 0, "", value_at(document, path)};
    if (is_item(path)) {
      insert.index = std::get<std::size_t>(path.back());
    } else {
      insert.key = std::get<std::string>(path.back());
    }
    const auto back = applied(*without, insert);
    ASSERT_TRUE(back.has_value()) << back.error().why;
    EXPECT_TRUE(says_same(*back, document)) << to_text(path);
  });
}

TEST(AppliedLaws, ANameThereAndBackIsNoChange) {
  for_places(3, [](const Value& document, const Path& path) {
    const auto renamed = applied(document, Rename{path, "fresh"});
    if (is_item(path)) {
      EXPECT_FALSE(renamed.has_value()) << to_text(path);
      return;
    }
    ASSERT_TRUE(renamed.has_value()) << renamed.error().why;
    Path now = around(path);
    now.emplace_back(std::string("fresh"));
    const auto back = applied(*renamed, Rename{now, std::get<std::string>(path.back())});
    ASSERT_TRUE(back.has_value());
    EXPECT_TRUE(identical(*back, document)) << to_text(path);
  });
}

bool begins_with(const Path& path, const Path& start) {
  return path.size() >= start.size() && std::equal(start.begin(), start.end(), path.begin());
}

// The place of the other list is counted anew once the item is gone: that is the whole difficulty.
TEST(AppliedLaws, AMoveIsTakingOutAndPuttingIn) {
  int moved = 0;
  for_places(4, [&](const Value& document, const Path& item) {
    if (!is_item(item)) return;
    for (const Path& into : places_in(document)) {
      if (value_at(document, into).kind != Value::Kind::kSequence) continue;
      const auto result = applied(document, Move{item, into, 1});
      if (begins_with(into, item)) {
        EXPECT_FALSE(result.has_value()) << to_text(item) << " into itself";
        continue;
      }
      ASSERT_TRUE(result.has_value()) << result.error().why;
      const auto without = applied(document, Remove{item});
      const auto by_hand =
          applied(*without, Insert{path_without(into, item), 1, "", value_at(document, item)});
      ASSERT_TRUE(by_hand.has_value()) << by_hand.error().why;
      EXPECT_TRUE(identical(*result, *by_hand)) << to_text(item) << " into " << to_text(into);
      ++moved;
    }
  });
  EXPECT_GT(moved, 100);
}

TEST(PathWithout, LeadsToTheSameValueOnceTheItemIsGone) {
  for_places(5, [](const Value& document, const Path& item) {
    if (!is_item(item)) return;
    const Value without = *applied(document, Remove{item});
    for (const Path& other : places_in(document)) {
      if (begins_with(other, item) || begins_with(item, other)) continue;
      EXPECT_TRUE(
          identical(value_at(without, path_without(other, item)), value_at(document, other)))
          << to_text(other) << " without " << to_text(item);
    }
  });
}

TEST(SaysSame, DoesNotCareForTheOrderOfEntriesButForThatOfItems) {
  Value ab, ba, list, turned;
  ab.kind = ba.kind = Value::Kind::kMap;
  ab.entries = {{"a", scalar_of("1")}, {"b", scalar_of("2")}};
  ba.entries = {{"b", scalar_of("2")}, {"a", scalar_of("1")}};
  list.kind = turned.kind = Value::Kind::kSequence;
  list.items = {scalar_of("1"), scalar_of("2")};
  turned.items = {scalar_of("2"), scalar_of("1")};

  EXPECT_TRUE(says_same(ab, ba));
  EXPECT_FALSE(says_same(list, turned));
  EXPECT_FALSE(says_same(ab, list));
  ba.entries[0].key = "c";
  EXPECT_FALSE(says_same(ab, ba));
}

TEST(Path, IsSaidAsItIsWrittenInMessages) {
  EXPECT_EQ(to_text(Path{}), "the document");
  EXPECT_EQ(to_text(Path{"roles", "perceive", std::size_t{2}, "type"}), "roles.perceive[2].type");
  EXPECT_EQ(to_text(Path{std::size_t{0}, "a"}), "[0].a");
}

struct WrongPlace {
  const char* what;
  Edit edit;
  const char* why;
};

TEST(Applied, EachEditThatCannotBeSaysWhy) {
  Value document;
  document.kind = Value::Kind::kMap;
  Value list;
  list.kind = Value::Kind::kSequence;
  list.items = {scalar_of("1")};
  document.entries = {{"a", list}, {"b", scalar_of("2")}};
  const Path first{"a", std::size_t{0}};
  const std::vector<WrongPlace> all = {
      {"set beyond the end", Set{{"a", std::size_t{1}}, {}}, "there is no a[1]"},
      {"set below a scalar", Set{{"b", "c"}, {}}, "there is no b.c"},
      {"remove everything", Remove{{}}, "there is no the document"},
      {"rename an item", Rename{first, "x"}, "there is no a[0]"},
      {"rename to nothing", Rename{{"a"}, ""}, "a key must not be empty"},
      {"rename to another", Rename{{"a"}, "b"}, "there is 'b' already"},
      {"a key into a list", Insert{{"a"}, 0, "k", {}}, "a is no map"},
      {"an item into a map", Insert{{}, 0, "", {}}, "the document is no list"},
      {"into nowhere", Insert{{"c"}, 0, "", {}}, "there is no c"},
      {"move an entry", Move{{"b"}, {"a"}, 0}, "only items of lists are moved"},
      {"move what is not there", Move{{"a", std::size_t{4}}, {"a"}, 0}, "there is no a[4]"},
      {"move into a scalar", Move{first, {"b"}, 0}, "b is no list"},
  };
  for (const WrongPlace& one : all) {
    const auto result = applied(document, one.edit);
    ASSERT_FALSE(result.has_value()) << one.what;
    EXPECT_EQ(result.error().why, one.why) << one.what;
  }
}

}  // namespace
}  // namespace skein::yaml_edit
