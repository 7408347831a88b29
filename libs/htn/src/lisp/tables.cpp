// SPDX-License-Identifier: Apache-2.0
// Hash tables and arrays: what a program changes in place.
#include <array>

#include "lisp/builtins.hpp"
#include "lisp/options.hpp"

namespace skein::htn::lisp {

namespace {

constexpr std::size_t kLargestArray = 10'000'000;

Term key_of(Machine& machine, const Machine::Table& table, Term key) {
  return table.loose ? machine.store().loose(key) : key;
}

// Terms are made once, so that eq, eql and equal are one; only equalp is another.
Outcome make_hash_table(Machine& machine, Arguments arguments) {
  Machine::Table table;
  for (std::size_t at = 0; at + 1 < arguments.size(); at += 2) {
    const bool test = machine.store().to_text(arguments[at]) == ":test";
    table.loose = table.loose || (test && machine.store().to_text(arguments[at + 1]) == "equalp");
  }
  return machine.add_table(std::move(table));
}

Outcome gethash(Machine& machine, Arguments arguments) {
  const Machine::Table* table = machine.table(arguments[1]);
  if (table == nullptr) return wrong_argument(machine, arguments, 1, "a hash table");
  const auto found = table->values.find(key_of(machine, *table, arguments[0]));
  if (found != table->values.end()) return found->second;
  return arguments.size() > 2 ? arguments[2] : kNil;
}

Outcome set_gethash(Machine& machine, Arguments arguments) {
  Machine::Table* table = machine.table(arguments[1]);
  if (table == nullptr) return wrong_argument(machine, arguments, 1, "a hash table");
  table->values.insert_or_assign(key_of(machine, *table, arguments[0]), arguments[2]);
  return arguments[2];
}

Outcome remhash(Machine& machine, Arguments arguments) {
  Machine::Table* table = machine.table(arguments[1]);
  if (table == nullptr) return wrong_argument(machine, arguments, 1, "a hash table");
  return TermStore::boolean(table->values.erase(key_of(machine, *table, arguments[0])) > 0);
}

Outcome clrhash(Machine& machine, Arguments arguments) {
  Machine::Table* table = machine.table(arguments[0]);
  if (table == nullptr) return wrong_argument(machine, arguments, 0, "a hash table");
  table->values.clear();
  return arguments[0];
}

Outcome hash_table_count(Machine& machine, Arguments arguments) {
  const Machine::Table* table = machine.table(arguments[0]);
  if (table == nullptr) return wrong_argument(machine, arguments, 0, "a hash table");
  return machine.store().integer(static_cast<std::int64_t>(table->values.size()));
}

// (make-array 5), (make-array '(2 3) :initial-element 0)
Outcome make_array(Machine& machine, Arguments arguments) {
  Machine::Array made;
  std::vector<Term> sizes{arguments[0]};
  if (!arguments[0].is(TermKind::kNumber)) {
    auto items = items_at(machine, arguments, 0);
    if (!items) return wrong_argument(machine, arguments, 0, "a size or a list of sizes");
    sizes = std::move(*items);
  }
  std::size_t count = 1;
  for (const Term size : sizes) {
    const std::array<Term, 1> one{size};
    const auto number = integer_at(machine, one, 0);
    const bool fits = number && *number >= 0 && *number <= static_cast<std::int64_t>(kLargestArray);
    if (!fits) return wrong_argument(machine, arguments, 0, "sizes from 0 to ten million");
    made.sizes.push_back(static_cast<std::size_t>(*number));
    count *= made.sizes.back();
    if (count > kLargestArray) return failure("an array of more than ten million items");
  }
  if (!machine.charge(count)) return failure(Machine::kTooLong);
  Term filled = kNil;
  for (std::size_t at = 1; at + 1 < arguments.size(); at += 2) {
    if (machine.store().to_text(arguments[at]) == ":initial-element") filled = arguments[at + 1];
  }
  made.items.assign(count, filled);
  return machine.add_array(std::move(made));
}

// The place of an item; `indices` are the arguments from the second on.
Result<Term*, Failure> item_of(Machine& machine, Arguments arguments, std::size_t indices) {
  Machine::Array* array = machine.array(arguments[0]);
  if (array == nullptr) return wrong_argument(machine, arguments, 0, "an array");
  if (array->sizes.size() != indices) {
    return failure("an array with " + std::to_string(array->sizes.size()) + " indices, not " +
                   std::to_string(indices));
  }
  std::size_t place = 0;
  for (std::size_t at = 0; at < indices; ++at) {
    const auto index = integer_at(machine, arguments, at + 1);
    if (!index) return tl::unexpected(index.error());
    if (*index < 0 || static_cast<std::size_t>(*index) >= array->sizes[at]) {
      return wrong_argument(machine, arguments, at + 1,
                            "an index below " + std::to_string(array->sizes[at]));
    }
    place = place * array->sizes[at] + static_cast<std::size_t>(*index);
  }
  return &array->items[place];
}

Outcome aref(Machine& machine, Arguments arguments) {
  const auto item = item_of(machine, arguments, arguments.size() - 1);
  if (!item) return tl::unexpected(item.error());
  return **item;
}

Outcome set_aref(Machine& machine, Arguments arguments) {
  const auto item = item_of(machine, arguments, arguments.size() - 2);
  if (!item) return tl::unexpected(item.error());
  **item = arguments.back();
  return arguments.back();
}

Outcome array_dimension(Machine& machine, Arguments arguments) {
  const Machine::Array* array = machine.array(arguments[0]);
  if (array == nullptr) return wrong_argument(machine, arguments, 0, "an array");
  const auto axis = integer_at(machine, arguments, 1);
  if (!axis) return tl::unexpected(axis.error());
  if (*axis < 0 || static_cast<std::size_t>(*axis) >= array->sizes.size()) {
    return wrong_argument(machine, arguments, 1, "one of its dimensions");
  }
  return machine.store().integer(
      static_cast<std::int64_t>(array->sizes[static_cast<std::size_t>(*axis)]));
}

constexpr std::array<Builtin, 10> kTables{{
    {"aref", 1, kAnyCount, aref},
    {"array-dimension", 2, 2, array_dimension},
    {"clrhash", 1, 1, clrhash},
    {"gethash", 2, 3, gethash},
    {"hash-table-count", 1, 1, hash_table_count},
    {"make-array", 1, kAnyCount, make_array},
    {"make-hash-table", 0, kAnyCount, make_hash_table},
    {"remhash", 2, 2, remhash},
    {"(setf aref)", 2, kAnyCount, set_aref},
    {"(setf gethash)", 3, 3, set_gethash},
}};

}  // namespace

std::span<const Builtin> table_builtins() { return kTables; }
const Builtin& array_setter() { return kTables[8]; }
const Builtin& hash_setter() { return kTables[9]; }

// The object of a table or array: which of them.
struct TableReference {
  std::size_t index = 0;
};
struct ArrayReference {
  std::size_t index = 0;
};

Term Machine::add_table(Table table) {
  tables_.push_back(std::move(table));
  return store().object(std::make_shared<const std::any>(TableReference{tables_.size() - 1}),
                        "hash-table");
}

Term Machine::add_array(Array array) {
  arrays_.push_back(std::move(array));
  return store().object(std::make_shared<const std::any>(ArrayReference{arrays_.size() - 1}),
                        "array");
}

Machine::Table* Machine::table(Term term) {
  if (!term.is(TermKind::kObject)) return nullptr;
  const auto* reference = std::any_cast<TableReference>(&store().host_value(term));
  const bool known = reference != nullptr && reference->index < tables_.size();
  return known ? &tables_[reference->index] : nullptr;
}

Machine::Array* Machine::array(Term term) {
  if (!term.is(TermKind::kObject)) return nullptr;
  const auto* reference = std::any_cast<ArrayReference>(&store().host_value(term));
  const bool known = reference != nullptr && reference->index < arrays_.size();
  return known ? &arrays_[reference->index] : nullptr;
}

}  // namespace skein::htn::lisp
