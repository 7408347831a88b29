// SPDX-License-Identifier: Apache-2.0
// Expressions as text, compiled and evaluated.
#pragma once

#include <gtest/gtest.h>

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "skein/htn/lisp.hpp"

namespace skein::htn::test {

/// A Lisp with clause variables: `?a` of a test has the value that `set` gave it.
class LispFixture {
 public:
  LispFixture() : lisp_(std::make_unique<Lisp>(store, functions, definitions)) {}

  TermStore store;
  Functions functions;
  std::vector<FunctionDefinition> definitions;

  /// Starts again with the functions and definitions that were added since.
  void restart() { lisp_ = std::make_unique<Lisp>(store, functions, definitions); }
  Lisp& lisp() { return *lisp_; }

  Expression read(const std::string& text) {
    Diagnostics problems;
    documents_.push_back(read_document("test.lisp", text, store, problems));
    EXPECT_TRUE(problems.empty()) << text << '\n' << to_text(problems);
    const Document& document = documents_.back();
    return {&document, document.top.empty() ? kNoNode : document.top.front()};
  }
  Term term(const std::string& text) {
    const Expression expression = read(text);
    Diagnostics errors;
    const CodeIndex code = lisp_->compile_template(expression, slot_of(), errors);
    EXPECT_TRUE(errors.empty()) << text << '\n' << to_text(errors);
    return evaluated(code).value_or(kNil);
  }
  /// (defun name (parameters) body…)
  void define(const std::string& text) {
    const Expression form = read(text);
    const std::vector<NodeIndex> parts = children(*form.document, form.node);
    FunctionDefinition definition;
    definition.name = store.name((*form.document)[parts[1]].atom);
    definition.parameters = {form.document, parts[2]};
    for (std::size_t at = 3; at < parts.size(); ++at) {
      definition.body.push_back({form.document, parts[at]});
    }
    definitions.push_back(definition);
    restart();
  }
  void set(const std::string& variable, Term value) {
    slots_.emplace(store.symbol(variable), static_cast<std::uint32_t>(values_.size()));
    values_.push_back(value);
  }
  void set(const std::string& variable, const std::string& value) { set(variable, term(value)); }

  SlotOf slot_of() {
    return [this](Term variable) -> std::optional<std::uint32_t> {
      const auto at = slots_.find(variable);
      if (at == slots_.end()) return std::nullopt;
      return at->second;
    };
  }
  SlotValue slots() {
    return [this](std::uint32_t slot) { return values_[slot]; };
  }
  tl::expected<Term, LispError> evaluated(CodeIndex code) {
    if (code == kNoCode) return tl::unexpected(LispError{"not compiled", {}});
    return lisp_->evaluate(code, slots());
  }

  /// The value as text; "error: why" for an error of evaluation, "load: why" for one of compiling.
  std::string value(const std::string& text) { return outcome(text, &Lisp::compile); }
  std::string call(const std::string& text) { return outcome(text, &Lisp::compile_call); }
  std::string task(const std::string& text) { return outcome(text, &Lisp::compile_template); }

  /// What the function that `text` designates gives for the arguments.
  std::string apply(const std::string& text, const std::vector<std::string>& arguments) {
    std::vector<Term> terms;
    for (const std::string& argument : arguments) terms.push_back(term(argument));
    Diagnostics errors;
    const CodeIndex code = lisp_->compile_function(read(text), slot_of(), errors);
    if (!errors.empty()) return "load: " + to_text(errors.all().front());
    return shown(lisp_->apply(code, terms, slots()));
  }

 private:
  using Compile = CodeIndex (Lisp::*)(Expression, const SlotOf&, Diagnostics&);

  std::string shown(const tl::expected<Term, LispError>& result) {
    return result ? store.to_text(*result) : "error: " + result.error().why;
  }
  std::string outcome(const std::string& text, Compile compile) {
    Diagnostics errors;
    const CodeIndex code = ((*lisp_).*compile)(read(text), slot_of(), errors);
    EXPECT_EQ(code == kNoCode, !errors.empty()) << text;
    if (!errors.empty()) return "load: " + to_text(errors.all().front());
    return shown(evaluated(code));
  }

  std::deque<Document> documents_;
  std::unique_ptr<Lisp> lisp_;
  std::unordered_map<Term, std::uint32_t> slots_;
  std::vector<Term> values_;
};

}  // namespace skein::htn::test
