// SPDX-License-Identifier: Apache-2.0
#include "skein/scenario/expectation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "skein/foundation/rounded_seconds.hpp"
#include "skein/scenario/measures.hpp"

namespace skein::scenario {

namespace {

using Records = std::vector<journal::Record>;

std::optional<MissionTime> first_match(const Pattern& pattern, const Records& records) {
  const auto found = std::find_if(records.begin(), records.end(),
                                  [&](const auto& record) { return pattern.matches(record); });
  return found == records.end() ? std::nullopt : std::optional<MissionTime>(found->at());
}

struct Interval {
  MissionTime from;
  MissionTime until;
  std::optional<MissionTime> before;  ///< excluded itself

  bool contains(MissionTime at) const {
    return at >= from && at <= until && (!before || at < *before);
  }
};

// The instants that count, or why there are none.
tl::expected<Interval, std::string> interval_of(const Window& window, const Records& records) {
  Interval interval{window.from, window.until, std::nullopt};
  if (window.after) {
    const auto reference = first_match(*window.after, records);
    if (!reference) return tl::unexpected<std::string>("never saw " + to_text(*window.after));
    interval.from = std::max(interval.from, *reference);
    if (window.within) interval.until = std::min(interval.until, *reference + *window.within);
  }
  if (window.before) interval.before = first_match(*window.before, records);
  return interval;
}

std::string interval_text(const Interval& interval) {
  std::string text = "from " + in_seconds(interval.from);
  if (interval.until != MissionTime::max()) text += " until " + in_seconds(interval.until);
  if (interval.before) text += " before " + in_seconds(*interval.before);
  return text;
}

std::string bounds_text(const ExpectEvent& expected) {
  if (!expected.at_most) return "at least " + std::to_string(expected.at_least);
  if (*expected.at_most == expected.at_least) return "exactly " + std::to_string(expected.at_least);
  return std::to_string(expected.at_least) + " to " + std::to_string(*expected.at_most);
}

Verdict check_inside(const ExpectEvent& expected, const Interval& interval,
                     const Records& records) {
  std::size_t inside = 0;
  std::string first_inside, first_outside;
  for (const auto& record : records) {
    if (!expected.event.matches(record)) continue;
    const bool counts = interval.contains(record.at());
    if (counts && ++inside == 1) first_inside = in_seconds(record.at());
    if (!counts && first_outside.empty()) first_outside = in_seconds(record.at());
  }
  const bool passed =
      inside >= expected.at_least && (!expected.at_most || inside <= *expected.at_most);
  std::string seen = std::to_string(inside) + " times";
  if (inside == 1) seen = "once";
  if (inside > 0) seen += std::string(inside > 1 ? ", first" : "") + " at " + first_inside;
  if (!passed)
    seen += "; expected " + bounds_text(expected) + " of " + to_text(expected.event) + " " +
            interval_text(interval);
  if (!passed && !first_outside.empty()) seen += "; outside of that at " + first_outside;
  return {"", passed, seen};
}

Verdict check_event(const ExpectEvent& expected, const Records& records, Duration allowed_late) {
  auto interval = interval_of(expected.window, records);
  if (!interval) return {"", expected.at_least == 0, interval.error()};
  Verdict in_time = check_inside(expected, *interval, records);
  const bool ends = interval->until != MissionTime::max();
  if (in_time.passed || expected.at_least == 0 || !ends || allowed_late <= Duration())
    return in_time;
  const MissionTime asked = std::exchange(interval->until, interval->until + allowed_late);
  Verdict late = check_inside(expected, *interval, records);
  if (late.passed) late.seen += ", later than asked: by " + in_seconds(asked);
  return late;
}

Verdict check_finally(const ExpectFinally& expected, const Records& records) {
  const auto last = std::find_if(records.rbegin(), records.rend(),
                                 [&](const auto& record) { return expected.of.matches(record); });
  if (last == records.rend()) return {"", false, "never saw " + to_text(expected.of)};
  return {"", expected.is.matches(*last), "last: " + journal::to_json(*last)};
}

Verdict check_measure(const ExpectMeasure& expected, const Records& records) {
  const auto measured = measure(expected, records);
  if (!measured) return {"", false, "nothing to measure: " + measured.error()};
  const bool passed = (!expected.at_least || measured->value >= *expected.at_least) &&
                      (!expected.at_most || measured->value <= *expected.at_most);
  const double rounded = std::round(measured->value * 1000) / 1000;
  std::string number = std::to_string(rounded);
  number.erase(number.find_last_not_of('0') + 1);
  if (number.back() == '.') number.pop_back();
  return {"", passed, number + measured->context};
}

struct Checker {
  const Records& records;
  Duration allowed_late;
  Verdict operator()(const ExpectEvent& e) const { return check_event(e, records, allowed_late); }
  Verdict operator()(const ExpectFinally& e) const { return check_finally(e, records); }
  Verdict operator()(const ExpectMeasure& e) const { return check_measure(e, records); }
};

}  // namespace

std::vector<Verdict> check(const std::vector<Expectation>& expectations,
                           const std::vector<journal::Record>& records, Duration allowed_late) {
  std::vector<Verdict> verdicts;
  for (const Expectation& expectation : expectations) {
    Verdict verdict = std::visit(Checker{records, allowed_late}, expectation.what);
    verdict.name = expectation.name;
    verdicts.push_back(std::move(verdict));
  }
  return verdicts;
}

}  // namespace skein::scenario
