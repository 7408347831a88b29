// SPDX-License-Identifier: Apache-2.0
// The expectations of a scenario file.
#include <algorithm>

#include "reading.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/journal/kinds.hpp"

namespace skein::scenario {

namespace {

using config::Reader;
using config::Value;

// What a plain scalar of a pattern means: a truth value, a whole number, a number, else text.
journal::Value value_of(const Reader& reader) {
  Diagnostics unused;
  Value scalar;
  scalar.kind = Value::Kind::kScalar;
  scalar.scalar = reader.text();
  const auto reads = [&](auto read) {
    Diagnostics errors;
    const auto value = read(Reader(scalar, "", errors));
    return errors.empty() ? std::optional<journal::Value>(value) : std::nullopt;
  };
  if (scalar.scalar == "true" || scalar.scalar == "false") return scalar.scalar == "true";
  if (const auto whole = reads([](const Reader& r) { return journal::Value(r.integer()); })) {
    return *whole;
  }
  if (const auto number = reads([](const Reader& r) { return journal::Value(r.number()); })) {
    return *number;
  }
  return scalar.scalar;
}

std::vector<std::string> kinds_of_records() {
  std::vector<std::string> names;
  for (const journal::Kind& kind : journal::kinds()) names.push_back(kind.name);
  return names;
}

/// The kinds that a pattern names; empty: it names none, or not rightly.
std::vector<const journal::Kind*> kinds_named(const Reader& reader) {
  std::vector<const journal::Kind*> named;
  const Reader kind = reader.optional("kind");
  if (!kind.present()) return named;
  for (const Reader& one : kind.is_sequence() ? items_of(kind) : std::vector{kind}) {
    const std::string name =
        one.name_among(kinds_of_records(), "a kind of record (docs/journal.md)");
    const journal::Kind* known = journal::find_kind(name);
    if (known == nullptr) return {};
    named.push_back(known);
  }
  return named;
}

/// What no record of these kinds says there would never be found.
void check_word(const Reader& said, const std::string& key,
                const std::vector<const journal::Kind*>& kinds) {
  std::vector<std::string> words;
  for (const journal::Kind* kind : kinds) {
    for (const journal::Kind::Field& field : kind->fields) {
      if (field.name != key) continue;
      if (field.words.empty()) return;
      words.insert(words.end(), field.words.begin(), field.words.end());
    }
  }
  if (!words.empty()) (void)said.name_among(words, "one of " + joined(words, ", "));
}

/// A field that no record of these kinds has would never be found either.
void check_fields(const Reader& reader, const std::vector<const journal::Kind*>& kinds) {
  if (kinds.empty()) return;
  std::vector<std::string> fields{"at", "node", "kind"};
  for (const journal::Kind* kind : kinds)
    for (const auto& field : kind->fields) fields.push_back(field.name);
  for (const auto& [key, field] : entries_of(reader)) {
    if (std::find(fields.begin(), fields.end(), key) == fields.end()) {
      field.error("no record of this kind has a field '" + key + "'", "a field of docs/journal.md",
                  nearest_name(key, fields));
      continue;
    }
    for (const Reader& one : field.is_sequence() ? items_of(field) : std::vector{field})
      check_word(one, key, kinds);
  }
}

/// Of records of these kinds.
Pattern read_pattern(const Reader& reader, const Names& names,
                     const std::vector<const journal::Kind*>& kinds) {
  Pattern pattern;
  check_fields(reader, kinds);
  for (const auto& [key, field] : entries_of(reader)) {
    std::vector<journal::Value> values;
    for (const Reader& one : field.is_sequence() ? items_of(field) : std::vector{field}) {
      if (key == "uav") (void)one.name_among(names.uavs, "a UAV");
      values.push_back(value_of(one));
    }
    pattern.fields.emplace_back(key, std::move(values));
  }
  if (reader.present() && pattern.fields.empty()) reader.error("an empty pattern matches anything");
  return pattern;
}

Pattern read_pattern(const Reader& reader, const Names& names) {
  return read_pattern(reader, names, kinds_named(reader));
}

Window read_window(const Reader& reader, const Names& names) {
  Window window;
  window.from = read_instant(reader.optional("from"));
  window.until = read_instant(reader.optional("until"), MissionTime::max());
  if (const Reader after = reader.optional("after"); after.present()) {
    window.after = read_pattern(after, names);
  }
  if (const Reader before = reader.optional("before"); before.present()) {
    window.before = read_pattern(before, names);
  }
  if (const Reader within = reader.optional("within"); within.present()) {
    window.within = read_seconds(within);
    if (!window.after) within.error("'within' counts from 'after', which is missing");
  }
  if (window.until < window.from) reader.error("a window that ends before it begins");
  return window;
}

ExpectEvent read_event(const Reader& reader, const Names& names) {
  ExpectEvent expected;
  expected.event = read_pattern(reader.required("event"), names);
  expected.window = read_window(reader, names);
  const Reader count = reader.optional("count");
  if (count.is_map()) {
    count.keys({"at_least", "at_most"});
    expected.at_least = static_cast<std::size_t>(count.optional("at_least").integer(0, 0, 1 << 30));
    if (count.optional("at_most").present()) {
      expected.at_most = static_cast<std::size_t>(count.optional("at_most").integer(0, 0, 1 << 30));
    }
    if (expected.at_most && *expected.at_most < expected.at_least)
      count.error("no count is within these bounds");
  } else if (count.present()) {
    expected.at_least = static_cast<std::size_t>(count.integer(1, 0, 1 << 30));
    expected.at_most = expected.at_least;
  }
  return expected;
}

ExpectMeasure read_measure(const Reader& reader, const Names& names,
                           const std::vector<ClosedAir>& air) {
  ExpectMeasure expected;
  const Reader quantity = reader.required("measure");
  expected.quantity = static_cast<ExpectMeasure::Quantity>(
      quantity.choice({"minimum-separation", "distance-flown", "mission-duration", "energy-left",
                       "time-in-volume"}));
  if (expected.quantity == ExpectMeasure::Quantity::kTimeInVolume) {
    expected.air = air;
    if (air.empty())
      quantity.error("no air is closed", "world.volumes, or close_air in the script");
  }
  for (const Reader& uav : items_of(reader.optional("uavs"))) {
    expected.uavs.push_back(uav.name_among(names.uavs, "a UAV"));
  }
  const Reader low = reader.optional("at_least");
  const Reader high = reader.optional("at_most");
  if (low.present()) expected.at_least = low.number();
  if (high.present()) expected.at_most = high.number();
  if (!low.present() && !high.present())
    reader.error("a measure without bounds", "at_least, at_most");
  if (expected.at_least && expected.at_most && *expected.at_most < *expected.at_least)
    reader.error("no figure is within these bounds");
  return expected;
}

ExpectEvent read_never(const Reader& reader, const Names& names) {
  ExpectEvent expected;
  expected.event = read_pattern(reader.required("never"), names);
  expected.window = read_window(reader, names);
  expected.at_least = 0;
  expected.at_most = 0;
  return expected;
}

}  // namespace

void read_expectations(const Reader& reader, const Names& names, const std::vector<ClosedAir>& air,
                       std::vector<Expectation>& expectations) {
  for (const Reader& item : items_of(reader)) {
    Expectation expectation;
    expectation.name = item.required("name").text();
    if (item.optional("event").present()) {
      item.keys({"name", "event", "from", "until", "after", "before", "within", "count"});
      expectation.what = read_event(item, names);
    } else if (item.optional("never").present()) {
      item.keys({"name", "never", "from", "until", "after", "before", "within"});
      expectation.what = read_never(item, names);
    } else if (item.optional("finally").present()) {
      item.keys({"name", "finally", "is"});
      const Reader last = item.required("finally");
      const auto kinds = kinds_named(last);
      expectation.what = ExpectFinally{read_pattern(last, names, kinds),
                                       read_pattern(item.required("is"), names, kinds)};
    } else if (item.optional("measure").present()) {
      item.keys({"name", "measure", "uavs", "at_least", "at_most"});
      expectation.what = read_measure(item, names, air);
    } else {
      item.keys({"name", "event", "never", "finally", "measure"});
      item.error("an expectation of no kind", "one of event, never, finally, measure");
    }
    expectations.push_back(std::move(expectation));
  }
}

}  // namespace skein::scenario
