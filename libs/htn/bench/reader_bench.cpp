// SPDX-License-Identifier: Apache-2.0
// How fast files are read: a problem of 50 MB, and one as large as they come with planners.
#include <benchmark/benchmark.h>

#include <string>

#include "skein/htn/definitions.hpp"

namespace {

using namespace skein;
using namespace skein::htn;

// Parcels, trucks and places as in a logistics problem, one fact a line.
std::string problem_of(std::size_t bytes) {
  std::string text = "(in-package :shop-user)\n(defproblem large logistics\n  (\n";
  for (std::size_t i = 0; text.size() < bytes; ++i) {
    const std::string number = std::to_string(i % 100'000);
    text += "    (OBJ-AT package" + number + " LOC" + std::to_string(i % 997) + "-1)\n";
    text += "    (capacity truck" + number + " " + std::to_string(i % 512) + ")\n";
    if (i % 16 == 0) text += "    ;; the next sixteen\n";
  }
  return text + "  )\n  (:unordered (deliver package1 LOC1-1) (deliver package2 LOC2-1)))\n";
}

void report(benchmark::State& state, const std::string& text) {
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(text.size()));
}

void BM_ReadDocument(benchmark::State& state) {
  const std::string text = problem_of(static_cast<std::size_t>(state.range(0)));
  for (auto unused : state) {
    TermStore store;
    Diagnostics problems;
    benchmark::DoNotOptimize(read_document("large.lisp", text, store, problems));
    if (!problems.empty()) state.SkipWithError("the text is wrong");
  }
  report(state, text);
}

void BM_ReadDefinitions(benchmark::State& state) {
  const std::string text = problem_of(static_cast<std::size_t>(state.range(0)));
  for (auto unused : state) {
    TermStore store;
    Definitions definitions;
    Diagnostics errors;
    Diagnostics warnings;
    read_definitions({"large.lisp", text}, store, {}, definitions, errors, warnings);
    if (definitions.problems.size() != 1) state.SkipWithError("the problem was not read");
  }
  report(state, text);
}

BENCHMARK(BM_ReadDocument)->Arg(20'000)->Arg(50'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ReadDefinitions)->Arg(20'000)->Arg(50'000'000)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
