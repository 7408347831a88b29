// SPDX-License-Identifier: Apache-2.0
// Finds what a file defines, at any depth in its Lisp forms.
#include <algorithm>
#include <memory>
#include <tuple>

#include "language/domain_reader.hpp"
#include "language/problem_reader.hpp"
#include "language/review.hpp"
#include "language/wanted_document.hpp"

namespace skein::htn {

namespace {

constexpr std::size_t kMostReported = 200;

void read_function(const ReadContext& context, Expression form) {
  const std::vector<Expression> all = parts(form);
  if (all.size() < 3 || !context.is_name(all[1])) return;
  FunctionDefinition made;
  made.name = context.name(all[1]);
  made.parameters = all[2];
  made.body.assign(all.begin() + 3, all.end());
  context.definitions.functions.push_back(std::move(made));
}

// (defvar name value), (defparameter …), and at the top of the text (setf *name* value …).
void read_globals(const ReadContext& context, Expression form, bool at_top) {
  const Term word = context.head(form);
  if (word == kNil) return;
  const std::string name = context.name(word);
  const bool defined = name == "defvar" || name == "defparameter" || name == "defconstant";
  const bool set = at_top && (name == "setf" || name == "setq");
  if (!defined && !set) return;
  for (Expression at = next(first(form)); at; at = next(at)) {
    const Expression value = next(at);
    if (!context.is_name(at)) return;
    FunctionDefinition made;
    made.variable = true;
    made.name = context.name(at);
    if (value) made.body.push_back(value);
    context.definitions.functions.push_back(std::move(made));
    if (defined || !value) return;
    at = value;
  }
}

// (let ((*ignore-singleton-variables* t) …) …): until where it says so; 0 when it does not.
std::uint32_t quiet_until(const ReadContext& context, Expression form) {
  const Words& words = context.words;
  const Term word = context.head(form);
  const Expression second = next(first(form));
  if ((word != words.let && word != words.let_star) || !second) return 0;
  for (Expression at = first(second); at; at = next(at)) {
    const bool named = context.head(at) == words.ignore_singletons;
    if (named && next(first(at)) && !context.is_nil(next(first(at)))) return (*form).end;
  }
  return 0;
}

bool too_deep(const ReadContext& context, Expression form) {
  if (form.document->depth <= kDeepestNesting) return false;
  const std::vector<Node>& nodes = form.document->nodes;
  std::vector<std::uint32_t> ends;  // of the lists that are open
  for (NodeIndex at = form.node; at < nodes.size() && nodes[at].begin < (*form).end; ++at) {
    if (!nodes[at].list) continue;
    while (!ends.empty() && ends.back() <= nodes[at].begin) ends.pop_back();
    ends.push_back(nodes[at].end);
    if (ends.size() <= kDeepestNesting) continue;
    context.error(form,
                  "a definition nested more than " + std::to_string(kDeepestNesting) + " deep");
    return true;
  }
  return false;
}

// Of two definitions with one name the later counts, as in Lisp.
template <class Definition>
void warn_second(const ReadContext& context, Expression form, const char* kind,
                 const std::vector<Definition>& all, std::size_t before) {
  if (all.size() <= before) return;
  const std::string& name = all.back().name;
  const auto same = [&name](const Definition& one) { return one.name == name; };
  if (std::none_of(all.begin(), all.end() - 1, same)) return;
  context.warn(form, "a second " + std::string(kind) + " '" + name + "'", "another name");
}

// One letter more, less or another, or two neighbours swapped.
bool nearly(std::string_view one, std::string_view other) {
  while (!one.empty() && !other.empty() && one.front() == other.front()) {
    one.remove_prefix(1);
    other.remove_prefix(1);
  }
  while (!one.empty() && !other.empty() && one.back() == other.back()) {
    one.remove_suffix(1);
    other.remove_suffix(1);
  }
  const bool swapped =
      one.size() == 2 && other.size() == 2 && one[0] == other[1] && one[1] == other[0];
  return swapped || (one.size() <= 1 && other.size() <= 1);
}

// (defdomian …): left out although it was meant to be read.
void warn_misspelt(const ReadContext& context, Expression form) {
  const Term word = context.head(form);
  if (word == kNil) return;
  const Words& words = context.words;
  for (const Term known : {words.defdomain, words.defproblem, words.make_problem}) {
    const std::string name = context.name(known);
    if (!nearly(context.name(word), name)) continue;
    context.warn(form, "'" + context.name(word) + "' defines nothing", "a definition", name);
  }
}

// (define (domain …) …): hierarchical where it has tasks or methods.
bool read_foreign(const ReadContext& context, Expression form) {
  static const std::vector<std::string> hierarchical = {":htn", ":task", ":tasks", ":method"};
  const Expression kind = next(first(form));
  if (context.head(form) != context.words.define || !kind || context.head(kind) == kNil) {
    return false;
  }
  const std::string what = context.name(context.head(kind));
  if (what != "domain" && what != "problem") return false;
  bool hddl = false;
  for (Expression part = next(kind); part; part = next(part)) {
    const std::string word = context.name(context.head(part));
    hddl = hddl || std::count(hierarchical.begin(), hierarchical.end(), word) > 0;
  }
  context.definitions.foreign.push_back({hddl ? "HDDL" : "PDDL", form});
  return true;
}

// True: the form was a definition, and nothing is looked for inside.
bool read_form(const ReadContext& context, Expression form) {
  const Term word = context.head(form);
  const Words& words = context.words;
  const bool domain = word == words.defdomain;
  const bool problem = word == words.defproblem || word == words.make_problem;
  if (domain || problem) {
    if (too_deep(context, form)) return true;
    const Definitions& all = context.definitions;
    const std::size_t domains = all.domains.size();
    const std::size_t problems = all.problems.size();
    if (domain) {
      DomainReader(context, form).read();
      warn_second(context, form, "domain", all.domains, domains);
    } else {
      read_problem(context, form);
      warn_second(context, form, "problem", all.problems, problems);
    }
    return true;
  }
  if (word == words.defun) read_function(context, form);
  if (read_foreign(context, form)) return true;
  warn_misspelt(context, form);
  return word == words.def_problem_set;
}

void find_forms(ReadContext& context, const Document& document) {
  std::vector<NodeIndex> open;
  std::uint32_t quiet = 0;
  for (const NodeIndex top : document.top) {
    open.push_back(top);
    while (!open.empty()) {
      const NodeIndex at = open.back();
      open.pop_back();
      if (document[at].next != kNoNode) open.push_back(document[at].next);
      const Expression form{&document, at};
      if (!context.is_list(form) || context.is_nil(form)) continue;
      quiet = std::max(quiet, quiet_until(context, form));
      context.singletons = context.wary && document[at].begin >= quiet;
      read_globals(context, form, at == top);
      if (!read_form(context, form)) open.push_back(document[at].first_child);
    }
  }
}

bool before(const Diagnostic& left, const Diagnostic& right) {
  return std::tie(left.line, left.column) < std::tie(right.line, right.column);
}

// File by file as they came, and in each in the order of the text. A file that is included twice
// has its errors once.
void append_in_order(const Diagnostics& found, Diagnostics& to) {
  std::vector<std::string> files;
  for (const Diagnostic& one : found.all()) {
    if (std::find(files.begin(), files.end(), one.file) == files.end()) files.push_back(one.file);
  }
  std::vector<Diagnostic> sorted;
  for (const std::string& file : files) {
    std::vector<Diagnostic> all;
    for (const Diagnostic& one : found.all()) {
      if (one.file == file) all.push_back(one);
    }
    std::stable_sort(all.begin(), all.end(), before);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    sorted.insert(sorted.end(), all.begin(), all.end());
  }
  for (std::size_t i = 0; i < std::min(sorted.size(), kMostReported); ++i) to.add(sorted[i]);
  if (sorted.size() <= kMostReported) return;
  const std::string rest = std::to_string(sorted.size() - kMostReported);
  to.add({files.front(), 0, 0, "", rest + " more", "", ""});
}

// Warnings only if they are wanted.
void read(SourceFile file, TermStore& store, const IncludeReader& include, Definitions& definitions,
          Findings findings, WantedProblems& wanted) {
  Diagnostics found;
  Diagnostics suspicious;
  const std::size_t domains = definitions.domains.size();
  const std::size_t problems = definitions.problems.size();
  definitions.documents.push_back(std::make_unique<Document>(
      read_document(std::move(file.name), std::move(file.text), store, found, wanted)));
  const Document& document = *definitions.documents.back();
  const Words words(store);
  ReadContext context{store, words, include, definitions, found, suspicious};
  context.wary = findings.warnings != nullptr;
  find_forms(context, document);
  if (context.wary) review(context, domains, problems);
  append_in_order(found, findings.errors);
  if (context.wary) append_in_order(suspicious, *findings.warnings);
}

}  // namespace

void read_definitions(SourceFile file, TermStore& store, const IncludeReader& include,
                      Definitions& definitions, Diagnostics& errors, Diagnostics& warnings) {
  WantedProblems all;
  read(std::move(file), store, include, definitions, {errors, &warnings}, all);
}

void read_definitions(SourceFile file, TermStore& store, const IncludeReader& include,
                      Definitions& definitions, Diagnostics& errors) {
  WantedProblems all;
  read(std::move(file), store, include, definitions, {errors, nullptr}, all);
}

void read_definitions(SourceFile file, TermStore& store, const IncludeReader& include,
                      Definitions& definitions, Findings findings, WantedProblems& wanted) {
  read(std::move(file), store, include, definitions, findings, wanted);
}

}  // namespace skein::htn
