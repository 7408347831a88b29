// SPDX-License-Identifier: Apache-2.0
// Any bytes as a file of plans: no crash; what is read can be judged against a problem, and shown
// and read again.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "skein/htn_tools/plan_json.hpp"
#include "skein/htn_tools/validator.hpp"

namespace {

using namespace skein::htn;  // NOLINT(google-build-using-namespace): what is fuzzed

constexpr const char* kText = R"((defdomain small
  ((:operator (!a ?x) ((on ?x)) ((on ?x)) ((off ?x)) 2)
   (:operator (!!b) () () () 0.5)
   (:method (both ?x ?y) two ((on ?x) (on ?y)) (:ordered (!a ?x) (:unordered (!a ?y) (!!b))))
   (:method (both ?x ?y) none () ())))
(defproblem p small ((on c) (on d)) ((both c d))))";

void require(bool condition) {
  if (!condition) std::abort();
}

struct Setting {
  TermStore store;
  Definitions definitions;
  skein::Diagnostics errors, warnings;
  Functions host;
  std::optional<Validator> validator;
  Setting() {
    const IncludeReader none = [](const std::string&, const std::string&) {
      return skein::Result<std::string, skein::Failure>(skein::failure("no such file"));
    };
    read_definitions({"small.lisp", kText}, store, none, definitions, errors, warnings);
    require(errors.empty() && definitions.domains.size() == 1 && definitions.problems.size() == 1);
    validator.emplace(definitions.domains.front(), definitions.functions, host, store, errors);
    require(errors.empty());
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Setting setting;
  skein::Diagnostics errors;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto plans = read_plans("fuzz", text, setting.store, errors);
  for (const GivenPlan& plan : plans) {
    const Validation judged =
        setting.validator->validate(setting.definitions.problems.front(), plan, {10'000, 100});
    require(!to_text(judged).empty());
    if (!errors.empty()) continue;
    std::string shown;
    append_json(to_plan(plan, false, setting.store), setting.store, {.tree = true}, shown);
    skein::Diagnostics again;
    const auto read = read_plans("again", "{\"plans\":[" + shown + "]}", setting.store, again);
    require(again.empty() && read.size() == 1 && read.front().steps.size() == plan.steps.size());
  }
  return 0;
}
