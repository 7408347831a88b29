// SPDX-License-Identifier: Apache-2.0
// What one evaluation of the terms that domains are full of costs.
#include <benchmark/benchmark.h>

#include "skein/htn/lisp.hpp"

namespace {

using namespace skein::htn;

void evaluate(benchmark::State& state, const std::string& text, const Number& value) {
  TermStore store;
  const Functions functions;
  const std::vector<FunctionDefinition> definitions;
  Lisp lisp(store, functions, definitions);
  skein::Diagnostics errors;
  const Document document = read_document("bench", text, store, errors);
  const SlotOf slot_of = [&](Term variable) -> std::optional<std::uint32_t> {
    return store.name(variable) == "?a" ? 0U : 1U;
  };
  const std::vector<Term> values{store.number(value), store.integer(17)};
  const SlotValue slots = [&](std::uint32_t slot) { return values[slot]; };
  const CodeIndex code = lisp.compile({&document, document.top.front()}, slot_of, errors);
  for ([[maybe_unused]] auto step : state) {
    benchmark::DoNotOptimize(lisp.evaluate(code, slots));
  }
}

BENCHMARK_CAPTURE(evaluate, increment, "(+ ?a 1)", integer(41));
BENCHMARK_CAPTURE(evaluate, increment_float, "(+ ?a 1)", single(1.5));
BENCHMARK_CAPTURE(evaluate, less, "(< ?a ?b)", integer(41));
BENCHMARK_CAPTURE(evaluate, not_same, "(not (eq '?a '?b))", integer(41));
BENCHMARK_CAPTURE(evaluate, largest, "(if (> ?a ?b) (max ?a ?b 3) (- ?a))", integer(41));

}  // namespace

BENCHMARK_MAIN();
