// SPDX-License-Identifier: Apache-2.0
#include "proof/fact_base.hpp"

#include <algorithm>

#include "skein/foundation/contract.hpp"

namespace skein::htn {

namespace {

constexpr std::uint32_t kNone = kNoFact;
constexpr std::size_t kFirstTable = 256;

std::size_t hash_of(Term predicate, std::span<const Term> arguments) {
  std::uint64_t hash = predicate.bits();
  for (const Term argument : arguments) {
    hash = (hash ^ argument.bits()) * 0x9E3779B97F4A7C15ULL;
    hash ^= hash >> 32U;
  }
  return static_cast<std::size_t>(hash);
}

}  // namespace

FactBase::Predicate& FactBase::predicate_of(Term symbol) {
  if (symbol.index() >= predicate_of_symbol_.size()) {
    predicate_of_symbol_.resize(symbol.index() + 1, kNone);
  }
  std::uint32_t& index = predicate_of_symbol_[symbol.index()];
  if (index == kNone) {
    index = static_cast<std::uint32_t>(predicates_.size());
    predicates_.emplace_back();
  }
  return predicates_[index];
}

FactIndex FactBase::find(Term atom) const {
  const Term loose = store_.loose(atom);
  if (!loose.is(TermKind::kPair) || loose.index() >= fact_of_pair_.size()) return kNoFact;
  const FactIndex fact = fact_of_pair_[loose.index()];
  const bool there = fact != kNoFact && facts_[fact].in_force && facts_[fact].atom == atom;
  return there ? fact : kNoFact;
}

FactIndex FactBase::find(Term predicate, std::span<const Term> arguments) const {
  const FactIndex fact = record_of(predicate, arguments);
  return fact != kNoFact && facts_[fact].in_force ? fact : kNoFact;
}

FactIndex FactBase::record_of(Term predicate, std::span<const Term> arguments) const {
  if (table_.empty() || predicate.index() >= predicate_of_symbol_.size()) return kNoFact;
  const std::uint32_t number = predicate_of_symbol_[predicate.index()];
  const std::size_t mask = table_.size() - 1;
  for (std::size_t at = hash_of(predicate, arguments) & mask; table_[at] != 0;
       at = (at + 1) & mask) {
    const FactIndex index = table_[at] - 1;
    const Fact& fact = facts_[index];
    if (fact.predicate != number || fact.argument_count != arguments.size()) continue;
    if (!std::equal(arguments.begin(), arguments.end(), arguments_.data() + fact.arguments))
      continue;
    return index;
  }
  return kNoFact;
}

// Under the arguments it has now.
void FactBase::enter(FactIndex index) {
  if (entries_ * 2 >= table_.size()) grow_table();
  const std::size_t mask = table_.size() - 1;
  const std::span<const Term> values = arguments(index);
  std::size_t at = hash_of(store_.car(facts_[index].atom), values) & mask;
  for (; table_[at] != 0; at = (at + 1) & mask) {
    if (table_[at] == index + 1) return;
  }
  table_[at] = index + 1;
  ++entries_;
}

// What was entered under another spelling is dropped; it is entered again when it comes back.
void FactBase::grow_table() {
  table_.assign(std::max(kFirstTable, table_.size() * 2), 0);
  entries_ = 0;
  for (FactIndex index = 0; index < facts_.size(); ++index) enter(index);
}

// The record of the atom, in force or not, under the term that represents all its equals.
FactIndex FactBase::fact_of(Term atom) {
  SKEIN_EXPECTS(atom.is(TermKind::kPair) && store_.car(atom).is(TermKind::kSymbol));
  const Term loose = store_.loose(atom);
  if (loose.index() >= fact_of_pair_.size()) {
    fact_of_pair_.resize(std::max<std::size_t>(store_.pair_count(), loose.index() + 1), kNoFact);
  }
  FactIndex& index = fact_of_pair_[loose.index()];
  if (index != kNoFact) return index;
  index = static_cast<FactIndex>(facts_.size());
  const Term symbol = store_.car(atom);
  Predicate& predicate = predicate_of(symbol);
  Fact fact;
  fact.atom = atom;
  fact.predicate = predicate_of_symbol_[symbol.index()];
  fact.local = static_cast<std::uint32_t>(predicate.facts.size());
  fact.arguments = static_cast<std::uint32_t>(arguments_.size());
  for (Term rest = store_.cdr(atom); rest.is(TermKind::kPair); rest = store_.cdr(rest)) {
    arguments_.push_back(store_.car(rest));
    ++fact.argument_count;
  }
  facts_.push_back(fact);
  predicate.facts.push_back(index);
  predicate.links.emplace_back();
  for (const auto& made : predicate.indexes) {
    made->links.emplace_back();
    made->bucket_of.push_back(bucket_for(*made, fact));
  }
  enter(index);
  return index;
}

void FactBase::add(Term atom, StepIndex producer) {
  const FactIndex fact = fact_of(atom);
  if (facts_[fact].in_force) {
    if (facts_[fact].atom == atom) set_producer(fact, producer);
    return;
  }
  if (facts_[fact].atom != atom) {
    trail_.push_back({Change::kSpelling, fact, facts_[fact].atom.index()});
    spell(fact, atom);
  }
  set_producer(fact, producer);
  insert(fact);
  trail_.push_back({Change::kAdded, fact, 0});
}

void FactBase::remove(Term atom, StepIndex deleter) {
  const FactIndex fact = recording_ ? fact_of(atom) : find(atom);
  if (fact == kNoFact) return;
  if (recording_) {
    if (deleter_.size() <= fact) deleter_.resize(facts_.size(), kInitialState);
    trail_.push_back({Change::kDeleter, fact, deleter_[fact]});
    deleter_[fact] = deleter;
  }
  if (!facts_[fact].in_force || facts_[fact].atom != atom) return;
  erase(fact);
  trail_.push_back({Change::kRemoved, fact, 0});
}

void FactBase::set_producer(FactIndex fact, StepIndex producer) {
  if (facts_[fact].producer == producer) return;
  trail_.push_back({Change::kProducer, fact, facts_[fact].producer});
  facts_[fact].producer = producer;
}

void FactBase::undo(Mark mark) {
  while (trail_.size() > mark) {
    const Undo undo = trail_.back();
    trail_.pop_back();
    switch (undo.change) {
      case Change::kAdded:
        erase(undo.fact);
        break;
      case Change::kRemoved:
        insert(undo.fact);
        break;
      case Change::kProducer:
        facts_[undo.fact].producer = undo.earlier;
        break;
      case Change::kDeleter:
        deleter_[undo.fact] = undo.earlier;
        break;
      case Change::kSpelling:
        spell(undo.fact, Term(TermKind::kPair, undo.earlier));
        break;
    }
  }
}

StepIndex FactBase::deleter(Term atom) const {
  const Term loose = store_.loose(atom);
  if (!loose.is(TermKind::kPair) || loose.index() >= fact_of_pair_.size()) return kInitialState;
  const FactIndex fact = fact_of_pair_[loose.index()];
  return fact == kNoFact || fact >= deleter_.size() ? kInitialState : deleter_[fact];
}

// An atom that is only `equalp` to the one recorded brings its own arguments.
void FactBase::spell(FactIndex fact, Term atom) {
  facts_[fact].atom = atom;
  std::uint32_t at = facts_[fact].arguments;
  for (Term rest = store_.cdr(atom); rest.is(TermKind::kPair); rest = store_.cdr(rest)) {
    arguments_[at++] = store_.car(rest);
  }
  const Fact& record = facts_[fact];
  for (const auto& index : predicates_[record.predicate].indexes) {
    index->bucket_of[record.local] = bucket_for(*index, record);
  }
  enter(fact);
}

void FactBase::insert(FactIndex fact) {
  Fact& record = facts_[fact];
  Predicate& predicate = predicates_[record.predicate];
  record.in_force = true;
  link(predicate.all, predicate.links, record, fact);
  for (const auto& index : predicate.indexes) {
    const std::uint32_t bucket = index->bucket_of[record.local];
    if (bucket != kNone) link(index->buckets[bucket], index->links, record, fact);
  }
}

void FactBase::erase(FactIndex fact) {
  Fact& record = facts_[fact];
  Predicate& predicate = predicates_[record.predicate];
  record.in_force = false;
  unlink(predicate.all, predicate.links, record);
  for (const auto& index : predicate.indexes) {
    const std::uint32_t bucket = index->bucket_of[record.local];
    if (bucket != kNone) unlink(index->buckets[bucket], index->links, record);
  }
}

void FactBase::link(Bucket& bucket, std::vector<FactLink>& links, const Fact& fact,
                    FactIndex index) {
  links[fact.local] = {kNoFact, bucket.head};
  if (bucket.head != kNoFact) links[facts_[bucket.head].local].previous = index;
  bucket.head = index;
  ++bucket.count;
}

void FactBase::unlink(Bucket& bucket, std::vector<FactLink>& links, const Fact& fact) {
  const FactLink link = links[fact.local];
  if (link.previous == kNoFact) {
    bucket.head = link.next;
  } else {
    links[facts_[link.previous].local].next = link.next;
  }
  if (link.next != kNoFact) links[facts_[link.next].local].previous = link.previous;
  --bucket.count;
}

std::optional<Term> FactBase::value_at(const Fact& fact, Path path) const {
  if (path.outer >= fact.argument_count) return std::nullopt;
  Term value = arguments_[fact.arguments + path.outer];
  if (path.inner == Path::kWhole) return value;
  for (std::uint8_t item = 0; item < path.inner && value.is(TermKind::kPair); ++item) {
    value = store_.cdr(value);
  }
  if (!value.is(TermKind::kPair)) return std::nullopt;
  return store_.car(value);
}

std::uint32_t FactBase::bucket_for(Index& index, const Fact& fact) const {
  const std::optional<Term> value = value_at(fact, index.path);
  if (!value) return kNone;
  const auto made = static_cast<std::uint32_t>(index.buckets.size());
  const auto [number, fresh] = index.numbers.try_emplace(value->bits(), made);
  if (fresh) index.buckets.emplace_back();
  return number->second;
}

FactBase::Index& FactBase::index_for(Predicate& predicate, Path path) {
  for (const auto& index : predicate.indexes) {
    if (index->path == path) return *index;
  }
  Index& index = *predicate.indexes.emplace_back(std::make_unique<Index>());
  index.path = path;
  index.links.resize(predicate.facts.size());
  index.bucket_of.reserve(predicate.facts.size());
  for (const FactIndex fact : predicate.facts) {
    index.bucket_of.push_back(bucket_for(index, facts_[fact]));
  }
  std::vector<FactIndex> newest_first;
  for (FactIndex at = predicate.all.head; at != kNoFact;
       at = predicate.links[facts_[at].local].next) {
    newest_first.push_back(at);
  }
  for (auto fact = newest_first.rbegin(); fact != newest_first.rend(); ++fact) {
    const std::uint32_t bucket = index.bucket_of[facts_[*fact].local];
    if (bucket != kNone) link(index.buckets[bucket], index.links, facts_[*fact], *fact);
  }
  return index;
}

FactBase::Cursor FactBase::all(Term predicate) const {
  const Predicate* facts = known_predicate(predicate);
  return facts == nullptr ? Cursor{} : Cursor{facts->all.head, &facts->links};
}

std::vector<Term> FactBase::atoms() const {
  std::vector<Term> out;
  for (const Fact& fact : facts_) {
    if (fact.in_force) out.push_back(fact.atom);
  }
  return out;
}

std::size_t FactBase::memory_bytes() const {
  std::size_t bytes = facts_.capacity() * sizeof(Fact) + arguments_.capacity() * sizeof(Term) +
                      (fact_of_pair_.capacity() + table_.capacity()) * sizeof(std::uint32_t) +
                      trail_.capacity() * sizeof(Undo) + deleter_.capacity() * sizeof(StepIndex);
  for (const Predicate& predicate : predicates_) {
    bytes += predicate.links.capacity() * sizeof(FactLink) +
             predicate.facts.capacity() * sizeof(FactIndex);
    for (const auto& index : predicate.indexes) {
      bytes += index->links.capacity() * sizeof(FactLink) + index->buckets.size() * 32 +
               index->bucket_of.capacity() * sizeof(std::uint32_t);
    }
  }
  return bytes;
}

}  // namespace skein::htn
