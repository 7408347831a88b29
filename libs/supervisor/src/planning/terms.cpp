// SPDX-License-Identifier: Apache-2.0
#include "planning/terms.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "skein/htn/utf8.hpp"

namespace skein::supervisor {

using htn::Term;
using htn::TermKind;
using htn::TermStore;

namespace {

bool is_symbol(const TermStore& store, Term term, std::string_view name) {
  return term.is(TermKind::kSymbol) && store.name(term) == name;
}

std::vector<Term> items_of(const TermStore& store, Term term) {
  return store.is_list(term) ? store.items(term) : std::vector<Term>{};
}

// (num 4), (num unlimited) or the number itself.
std::optional<double> bound_of(const TermStore& store, Term term) {
  const std::vector<Term> items = items_of(store, term);
  const bool wrapped = items.size() == 2 && is_symbol(store, items[0], "num");
  const Term bare = wrapped ? items[1] : term;
  if (is_symbol(store, bare, "unlimited")) return std::numeric_limits<double>::infinity();
  return number_of(store, bare);
}

}  // namespace

std::string text_of(const TermStore& store, Term term) {
  switch (term.kind()) {
    case TermKind::kSymbol:
      return std::string(store.name(term));
    case TermKind::kString:
      return store.text(term);
    case TermKind::kNumber:
      return htn::to_text(store.value(term));
    default:
      return {};
  }
}

std::optional<double> number_of(const TermStore& store, Term term) {
  if (!term.is(TermKind::kNumber)) return std::nullopt;
  const double value = to_double(store.value(term));
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<world::Vector3> location_of(const TermStore& store, Term term) {
  const std::vector<Term> items = items_of(store, term);
  if (items.size() != 4 || !is_symbol(store, items[0], "loc")) return std::nullopt;
  const auto x = number_of(store, items[1]), y = number_of(store, items[2]),
             z = number_of(store, items[3]);
  if (!x || !y || !z) return std::nullopt;
  return world::Vector3(*x, *y, *z);
}

std::vector<world::Vector3> locations_of(const TermStore& store, Term list) {
  std::vector<world::Vector3> points;
  for (const Term one : items_of(store, list))
    if (const auto at = location_of(store, one)) points.push_back(*at);
  return points;
}

std::optional<Seconds> seconds_of(const TermStore& store, Term term) {
  const std::vector<Term> items = items_of(store, term);
  if (items.size() != 2) return std::nullopt;
  const auto least = bound_of(store, items[0]), most = bound_of(store, items[1]);
  if (!least || !most || !std::isfinite(*least)) return std::nullopt;
  return Seconds{*least, *most};
}

Term unquoted(const TermStore& store, Term term) {
  const std::vector<Term> items = items_of(store, term);
  return items.size() == 2 && is_symbol(store, items[0], "quote") ? items[1] : term;
}

Term number_term(TermStore& store, double value) {
  const bool whole = std::abs(value) < 1e15 && value == std::floor(value);
  return whole ? store.integer(static_cast<std::int64_t>(value)) : store.number(htn::real(value));
}

Term location_term(TermStore& store, const world::Vector3& at) {
  const std::vector<Term> items = {store.symbol("loc"), store.number(htn::real(at.x())),
                                   store.number(htn::real(at.y())),
                                   store.number(htn::real(at.z()))};
  return store.list(items);
}

Term headed(TermStore& store, std::string_view head, std::vector<Term> items) {
  items.insert(items.begin(), store.symbol(head));
  return store.list(items);
}

bool same_name(std::string_view a, std::string_view b) {
  const auto is_ascii = [](unsigned char x) { return x < 0x80; };
  const auto same = [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  };
  if (std::all_of(a.begin(), a.end(), is_ascii))
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
  return htn::lowered(a) == htn::lowered(b);  // as symbols are
}

htn::Term target_term(htn::TermStore& store, const world::Vector3& at) {
  const std::vector<htn::Term> one = {headed(store, "target", {location_term(store, at)})};
  return store.list(one);
}

}  // namespace skein::supervisor
