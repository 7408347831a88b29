// SPDX-License-Identifier: Apache-2.0
#include "by_cause.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>

#include "skein/journal/lines/execution.hpp"
#include "skein/journal/lines/radio.hpp"
#include "skein/journal/lines/truth.hpp"

namespace skein::laws {

namespace {

namespace lines = journal::lines;

using journal::Record;

/// A message, or the word of a synchronisation: kind, from, to, number.
using Word = std::tuple<std::string, std::string, std::string, double>;

std::optional<Word> word_of(const Record& record) {
  const bool message = record.kind() == lines::Message::kKind;
  if (!message && record.kind() != lines::Sync::kKind) return std::nullopt;
  return Word{record.kind(), record.text("from"), record.text("to"),
              record.number(message ? "sequence" : "id")};
}

bool is_birth(const Record& record) {
  return record.kind() == lines::Fault::kKind && record.text("what") == "restart";
}

Record at_time(const Record& record, MissionTime at) {
  Record moved(at, record.node(), record.kind());
  for (const auto& [key, value] : record.fields()) moved.with(key, value);
  return moved;
}

/// Where each word is sent in the log, in its order.
std::map<Word, std::vector<std::size_t>> sendings_in(const std::vector<Record>& records) {
  std::map<Word, std::vector<std::size_t>> sendings;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const auto word = word_of(records[i]);
    if (word && records[i].text("direction") == "sent") sendings[*word].push_back(i);
  }
  return sendings;
}

/// Where what is received at `i` is sent afterwards; absent: it was sent before, since its sender
/// lives, or it is not sent within `skew`.
std::optional<std::size_t> sent_afterwards(const std::vector<Record>& records, std::size_t i,
                                           const std::vector<std::size_t>& sendings,
                                           std::size_t birth, Duration skew) {
  const auto next = std::lower_bound(sendings.begin(), sendings.end(), i);
  if (next != sendings.begin() && *std::prev(next) >= birth) return std::nullopt;
  if (next == sendings.end() || records[*next].at() > records[i].at() + skew) return std::nullopt;
  return *next;
}

}  // namespace

std::vector<Record> by_cause(const std::vector<Record>& records, Duration skew) {
  const auto sendings = sendings_in(records);
  std::map<std::string, std::size_t> births;
  std::vector<std::pair<std::size_t, std::size_t>> places;  // after which line, itself
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (is_birth(records[i])) births[std::string(records[i].text("target"))] = i;
    const auto word = word_of(records[i]);
    const auto sent = word ? sendings.find(*word) : sendings.end();
    const bool received = sent != sendings.end() && records[i].text("direction") == "received";
    const auto cause =
        received ? sent_afterwards(records, i, sent->second, births[std::get<1>(*word)], skew)
                 : std::nullopt;
    places.emplace_back(cause.value_or(i), i);
  }
  // What is moved stands before its cause, and comes after it.
  std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first, a.first != a.second) < std::pair(b.first, b.first != b.second);
  });
  std::vector<Record> ordered;
  ordered.reserve(records.size());
  for (const auto& [cause, i] : places)
    ordered.push_back(cause == i ? records[i] : at_time(records[i], records[cause].at()));
  return ordered;
}

}  // namespace skein::laws
