// SPDX-License-Identifier: Apache-2.0
// Keeps every term once: equality is comparison of handles.
#pragma once

#include <any>
#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "skein/htn/number.hpp"
#include "skein/htn/term.hpp"

namespace skein::htn {

/// What occurs anywhere inside a term (bits).
enum TermContent : std::uint8_t {
  kHasSlot = 1,       ///< a clause variable
  kHasVariable = 2,   ///< a search variable
  kHasLocal = 4,      ///< a renamed variable
  kHasLooseEqual = 8  ///< a float, ratio or string: `equalp` may differ from `equal`
};

/// Owner of all terms of a domain, its problems and searches on them. Nothing is ever removed.
/// Memory: 20 to 30 bytes for a pair. Thread rule: one thread at a time.
class TermStore {
 public:
  TermStore();

  /// Case does not count.
  Term symbol(std::string_view name);
  Term number(const Number& value);
  Term integer(std::int64_t value) { return number(htn::integer(value)); }
  Term string(std::string_view text);
  Term pair(Term car, Term cdr) {
    const std::size_t place = place_of_pair(car, cdr);
    const std::uint32_t known = pair_table_[place];
    return known != 0 ? Term(TermKind::kPair, known - 1) : add_pair(car, cdr, place);
  }
  /// The pair if it was ever made.
  std::optional<Term> find_pair(Term car, Term cdr) const {
    const std::uint32_t known = pair_table_[place_of_pair(car, cdr)];
    if (known == 0) return std::nullopt;
    return Term(TermKind::kPair, known - 1);
  }
  Term list(std::span<const Term> items, Term tail = kNil);
  Term object(std::shared_ptr<const std::any> value, std::string label);
  static Term boolean(bool value) { return value ? kTrue : kNil; }

  std::string_view name(Term symbol) const { return names_[symbol.index()]; }
  const Number& value(Term number) const { return numbers_[number.index()]; }
  const std::string& text(Term string) const { return strings_[string.index()]; }
  Term car(Term pair) const { return pairs_[pair.index()].car; }
  Term cdr(Term pair) const { return pairs_[pair.index()].cdr; }
  const std::any& host_value(Term object) const { return *objects_[object.index()].value; }

  std::uint8_t content(Term term) const {
    if (term.is(TermKind::kPair)) return pair_content_[term.index()];
    if (term.is(TermKind::kNumber)) return number_content_[term.index()];
    constexpr std::array<std::uint8_t, 8> kOfKind{0, 0,        kHasLooseEqual, 0,
                                                  0, kHasSlot, kHasVariable,   kHasLocal};
    return kOfKind[static_cast<std::size_t>(term.kind())];
  }
  /// No variable of any kind inside.
  bool ground(Term term) const {
    return (content(term) & (kHasSlot | kHasVariable | kHasLocal)) == 0;
  }
  /// The representative of all terms that are `equalp` to this one: numbers by value, strings
  /// without case. The same term for nearly all terms, at no cost.
  Term loose(Term term);

  /// The items of a proper list; what follows the last pair is ignored.
  std::vector<Term> items(Term list) const;
  /// Proper list: nil, or pairs ending in nil.
  bool is_list(Term term) const;
  std::string to_text(Term term) const;

  std::size_t pair_count() const { return pairs_.size(); }
  std::size_t memory_bytes() const;

 private:
  struct Pair {
    Term car;
    Term cdr;
  };
  struct SymbolSlot {
    std::uint32_t hash = 0;
    std::uint32_t index = 0;  ///< 0: free, else index + 1
  };
  struct Object {
    std::shared_ptr<const std::any> value;
    std::string label;
  };
  Term symbol_of(std::string_view name, std::uint32_t hash);
  void grow_symbol_table();
  void grow_number_table();
  void grow_pair_table();
  Term add_pair(Term car, Term cdr, std::size_t place);
  // Where the pair stands in the table, or would stand.
  std::size_t place_of_pair(Term car, Term cdr) const {
    const std::uint64_t key = (std::uint64_t{car.bits()} << 32U) | cdr.bits();
    std::size_t at = static_cast<std::size_t>(((key ^ (key >> 32U)) * 0x9E3779B97F4A7C15ULL) >>
                                              pair_table_shift_);
    while (true) {
      const std::uint32_t known = pair_table_[at];
      if (known == 0) return at;
      const Pair& pair = pairs_[known - 1];
      if (pair.car == car && pair.cdr == cdr) return at;
      at = (at + 1) & (pair_table_.size() - 1);
    }
  }
  Term loose_part(Term part);
  void append_text(Term term, std::string& out) const;
  void append_atom(Term term, std::string& out) const;

  std::deque<std::string> symbols_;
  std::vector<std::string_view> names_;   // the same
  std::vector<SymbolSlot> symbol_table_;  // open addressing, never more than half full
  std::vector<Number> numbers_;
  std::vector<std::uint8_t> number_content_;
  std::vector<std::uint32_t> number_table_;  // open addressing; 0: free, else index + 1
  std::deque<std::string> strings_;
  std::unordered_map<std::string_view, std::uint32_t> string_index_;
  std::vector<Pair> pairs_;
  std::vector<std::uint8_t> pair_content_;
  std::vector<std::uint32_t> pair_table_;  // open addressing; 0: free, else index + 1
  std::uint32_t pair_table_shift_;         // of a hash of 64 bits, to as many as the table has
  std::vector<Object> objects_;
  std::vector<Term> loose_pairs_;  // by the index of the pair; kNil: not asked for yet
  std::vector<Term> loose_open_;   // pairs that loose() works out
};

}  // namespace skein::htn
