// SPDX-License-Identifier: Apache-2.0
#include "skein/htn/term_store.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "skein/foundation/contract.hpp"
#include "skein/htn/utf8.hpp"

namespace skein::htn {

namespace {

constexpr std::size_t kFirstTable = 1024;
constexpr std::size_t kFirstPairTable = 4096;  // the terms of a small domain
constexpr std::size_t kLargestIndex = (std::size_t{1} << 29) - 1;

std::uint64_t mix(std::uint64_t value) {
  value ^= value >> 32U;
  value *= 0x9E3779B97F4A7C15ULL;
  return value ^ (value >> 29U);
}

std::size_t number_hash(const Number& value) {
  const auto kind = static_cast<std::uint64_t>(value.kind);
  const bool exact = value.kind == NumberKind::kInteger || value.kind == NumberKind::kRatio;
  const std::uint64_t bits = exact ? static_cast<std::uint64_t>(value.numerator) * 31 +
                                         static_cast<std::uint64_t>(value.denominator)
                                   : std::bit_cast<std::uint64_t>(value.real);
  return mix(bits ^ (kind << 61U));
}

// Eight letters at once: sets bit 5 of each byte from 'A' to 'Z'.
inline std::uint64_t lower_eight(std::uint64_t bytes) {
  constexpr std::uint64_t kOnes = 0x0101010101010101ULL;
  constexpr std::uint64_t kHigh = 0x80 * kOnes;
  const std::uint64_t low = bytes & ~kHigh;
  const std::uint64_t from_a = low + (0x80 - 'A') * kOnes;
  const std::uint64_t beyond_z = low + (0x7F - 'Z') * kOnes;
  return bytes | (((from_a ^ beyond_z) & ~bytes & kHigh) >> 2U);
}

template <class Word>
std::uint64_t word_at(const char* text) {
  Word word = 0;
  std::memcpy(&word, text, sizeof(Word));
  return word;
}

// Up to eight letters; fewer by two words that overlap, for short names are most.
inline std::uint64_t eight_at(std::string_view text, std::size_t at) {
  const char* begin = text.data() + at;
  const std::size_t size = text.size() - at;
  if (size >= 8) return word_at<std::uint64_t>(begin);
  if (size >= 4) {
    return word_at<std::uint32_t>(begin) | word_at<std::uint32_t>(begin + size - 4)
                                               << (8 * (size - 4));
  }
  if (size >= 2) {
    return word_at<std::uint16_t>(begin) | word_at<std::uint16_t>(begin + size - 2)
                                               << (8 * (size - 2));
  }
  return word_at<std::uint8_t>(begin);
}

struct NameHash {
  std::uint32_t hash = 0;
  bool plain = true;  ///< no letters beyond ASCII
};

// Case does not count.
inline NameHash name_hash(std::string_view name) {
  std::uint64_t hash = name.size();
  std::uint64_t seen = 0;
  for (std::size_t at = 0; at < name.size(); at += 8) {
    const std::uint64_t letters = eight_at(name, at);
    seen |= letters;
    hash = mix(hash ^ lower_eight(letters));
  }
  return {static_cast<std::uint32_t>(hash), (seen & 0x8080808080808080ULL) == 0};
}

inline bool is_lowered(std::string_view name, std::string_view lowered) {
  if (name.size() != lowered.size()) return false;
  for (std::size_t at = 0; at < name.size(); at += 8) {
    if (lower_eight(eight_at(name, at)) != eight_at(lowered, at)) return false;
  }
  return true;
}

std::uint32_t checked_index(std::size_t size) {
  SKEIN_ENSURES(size <= kLargestIndex);
  return static_cast<std::uint32_t>(size);
}

// What stands for a number or string and all that are `equalp` to it.
Term loose_leaf(TermStore& store, Term term) {
  if (term.is(TermKind::kString)) return store.string(lowered(store.text(term)));
  const Number& number = store.value(term);
  const double exact = number.kind == NumberKind::kRatio ? to_double(number) : number.real;
  constexpr double kExactInteger = 9007199254740992.0;
  if (number.kind != NumberKind::kRatio && exact >= -kExactInteger && exact <= kExactInteger) {
    const auto whole = static_cast<std::int64_t>(exact);
    if (static_cast<double>(whole) == exact) return store.integer(whole);
  }
  return store.number(real(exact));
}

}  // namespace

TermStore::TermStore()
    : symbol_table_(kFirstTable),
      number_table_(kFirstTable, 0),
      pair_table_(kFirstPairTable, 0),
      pair_table_shift_(64 - std::bit_width(kFirstPairTable - 1)) {
  symbol("nil");
  symbol("t");
}

Term TermStore::symbol(std::string_view given) {
  const NameHash asked = name_hash(given);
  if (asked.plain) return symbol_of(given, asked.hash);
  const std::string folded = lowered(given);
  return symbol_of(folded, name_hash(folded).hash);
}

// By the hash of its name; of a name with letters beyond ASCII, which is in lower case already.
Term TermStore::symbol_of(std::string_view name, std::uint32_t hash) {
  const std::size_t mask = symbol_table_.size() - 1;
  std::size_t at = hash & mask;
  for (; symbol_table_[at].index != 0; at = (at + 1) & mask) {
    const std::uint32_t index = symbol_table_[at].index - 1;
    if (symbol_table_[at].hash == hash && is_lowered(name, names_[index])) {
      return {TermKind::kSymbol, index};
    }
  }
  const std::uint32_t index = checked_index(symbols_.size());
  symbols_.push_back(lowered(name));
  names_.emplace_back(symbols_.back());
  symbol_table_[at] = {hash, index + 1};
  if (symbols_.size() * 2 > symbol_table_.size()) grow_symbol_table();
  return {TermKind::kSymbol, index};
}

void TermStore::grow_symbol_table() {
  std::vector<SymbolSlot> table(symbol_table_.size() * 2);
  const std::size_t mask = table.size() - 1;
  for (const SymbolSlot& slot : symbol_table_) {
    if (slot.index == 0) continue;
    std::size_t at = slot.hash & mask;
    while (table[at].index != 0) at = (at + 1) & mask;
    table[at] = slot;
  }
  symbol_table_ = std::move(table);
}

Term TermStore::number(const Number& value) {
  const std::size_t mask = number_table_.size() - 1;
  std::size_t at = number_hash(value) & mask;
  for (; number_table_[at] != 0; at = (at + 1) & mask) {
    const std::uint32_t index = number_table_[at] - 1;
    if (numbers_[index] == value) return {TermKind::kNumber, index};
  }
  const std::uint32_t index = checked_index(numbers_.size());
  numbers_.push_back(value);
  number_content_.push_back(value.kind == NumberKind::kInteger ? 0 : kHasLooseEqual);
  number_table_[at] = index + 1;
  if (numbers_.size() * 2 > number_table_.size()) grow_number_table();
  return {TermKind::kNumber, index};
}

void TermStore::grow_number_table() {
  std::vector<std::uint32_t> table(number_table_.size() * 2, 0);
  const std::size_t mask = table.size() - 1;
  for (std::uint32_t index = 0; index < numbers_.size(); ++index) {
    std::size_t at = number_hash(numbers_[index]) & mask;
    while (table[at] != 0) at = (at + 1) & mask;
    table[at] = index + 1;
  }
  number_table_ = std::move(table);
}

Term TermStore::string(std::string_view text) {
  const auto known = string_index_.find(text);
  if (known != string_index_.end()) return {TermKind::kString, known->second};
  const std::uint32_t index = checked_index(strings_.size());
  strings_.emplace_back(text);
  string_index_.emplace(strings_.back(), index);
  return {TermKind::kString, index};
}

Term TermStore::add_pair(Term car, Term cdr, std::size_t place) {
  const std::uint32_t index = checked_index(pairs_.size());
  pairs_.push_back({car, cdr});
  pair_content_.push_back(static_cast<std::uint8_t>(content(car) | content(cdr)));
  pair_table_[place] = index + 1;
  if (pairs_.size() * 2 > pair_table_.size()) grow_pair_table();
  return {TermKind::kPair, index};
}

void TermStore::grow_pair_table() {
  pair_table_.assign(pair_table_.size() * 2, 0);
  --pair_table_shift_;
  for (std::uint32_t index = 0; index < pairs_.size(); ++index) {
    pair_table_[place_of_pair(pairs_[index].car, pairs_[index].cdr)] = index + 1;
  }
}

Term TermStore::list(std::span<const Term> items, Term tail) {
  for (auto at = items.rbegin(); at != items.rend(); ++at) tail = pair(*at, tail);
  return tail;
}

Term TermStore::object(std::shared_ptr<const std::any> value, std::string label) {
  const std::uint32_t index = checked_index(objects_.size());
  objects_.push_back({std::move(value), std::move(label)});
  return {TermKind::kObject, index};
}

// Of a pair it is worked out when it is first asked for, which few ever are, and from the inside:
// no recursion into deep terms.
Term TermStore::loose(Term term) {
  const Term known = loose_part(term);
  if (known != kNil || term == kNil) return known;
  loose_open_.assign(1, term);
  while (true) {
    const Term next = loose_open_.back();
    const Term first = car(next), rest = cdr(next);
    const Term head = loose_part(first), tail = loose_part(rest);
    const bool head_open = head == kNil && first != kNil;
    const bool tail_open = tail == kNil && rest != kNil;
    if (head_open) loose_open_.push_back(first);
    if (tail_open) loose_open_.push_back(rest);
    if (head_open || tail_open) continue;
    loose_open_.pop_back();
    const Term representative = pair(head, tail);
    if (loose_pairs_.size() < pairs_.size()) loose_pairs_.resize(pairs_.capacity(), kNil);
    loose_pairs_[next.index()] = representative;
    if (loose_open_.empty()) return representative;
  }
}

// What is known of it without looking inside: kNil of a pair that nobody asked for yet.
Term TermStore::loose_part(Term part) {
  if ((content(part) & kHasLooseEqual) == 0) return part;
  if (!part.is(TermKind::kPair)) return loose_leaf(*this, part);
  return part.index() < loose_pairs_.size() ? loose_pairs_[part.index()] : kNil;
}

std::vector<Term> TermStore::items(Term list) const {
  std::vector<Term> out;
  for (; list.is(TermKind::kPair); list = cdr(list)) out.push_back(car(list));
  return out;
}

bool TermStore::is_list(Term term) const {
  while (term.is(TermKind::kPair)) term = cdr(term);
  return term == kNil;
}

std::string TermStore::to_text(Term term) const {
  std::string out;
  append_text(term, out);
  return out;
}

void TermStore::append_atom(Term term, std::string& out) const {
  switch (term.kind()) {
    case TermKind::kSymbol:
      out += name(term);
      return;
    case TermKind::kNumber:
      out += htn::to_text(value(term));
      return;
    case TermKind::kString:
      out += '"';
      for (const char letter : text(term)) {
        if (letter == '"' || letter == '\\') out += '\\';
        out += letter;
      }
      out += '"';
      return;
    case TermKind::kObject:
      out += "#<" + objects_[term.index()].label + '>';
      return;
    default:
      out += "?_" + std::to_string(term.index());
  }
}

// An explicit stack: a list nested a million deep is only long to print.
void TermStore::append_text(Term term, std::string& out) const {
  std::vector<Term> rests;  // what remains of each list that is open
  bool fresh = true;        // `term` is to be written; else go on with the innermost list
  while (true) {
    if (fresh) {
      if (term.is(TermKind::kPair)) {
        out += '(';
        rests.push_back(cdr(term));
        term = car(term);
        continue;
      }
      append_atom(term, out);
    }
    if (rests.empty()) return;
    const Term rest = rests.back();
    fresh = rest.is(TermKind::kPair);
    if (fresh) {
      out += ' ';
      rests.back() = cdr(rest);
      term = car(rest);
      continue;
    }
    if (rest != kNil) {
      out += " . ";
      append_atom(rest, out);
    }
    out += ')';
    rests.pop_back();
  }
}

std::size_t TermStore::memory_bytes() const {
  return pairs_.capacity() * (sizeof(Pair) + 1) + loose_pairs_.capacity() * sizeof(Term) +
         pair_table_.capacity() * sizeof(std::uint32_t) +
         numbers_.capacity() * (sizeof(Number) + 48) + symbols_.size() * 96 + strings_.size() * 96;
}

}  // namespace skein::htn
