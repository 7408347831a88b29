// SPDX-License-Identifier: Apache-2.0
#include "library.hpp"

#include <algorithm>
#include <filesystem>

#include "file_text.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::plan_tool {

namespace {

namespace fs = std::filesystem;

Diagnostic about(std::string file, std::string message) {
  Diagnostic out;
  out.file = std::move(file);
  out.message = std::move(message);
  return out;
}

// Beside the file that includes it; an absolute path stays.
Result<std::string, Failure> included(const std::string& name, const std::string& from,
                                      std::istream& in) {
  const fs::path base = from == "-" ? fs::path() : fs::path(from).parent_path();
  return text_of_file((base / name).string(), in);
}

template <class Definition>
std::vector<std::string> names_of(const std::vector<Definition>& definitions) {
  std::vector<std::string> names;
  for (const Definition& one : definitions) names.push_back(one.name);
  return names;
}

// "a, b or c"; of many the first few.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 10;
  std::string out;
  const std::size_t shown = std::min(names.size(), kMost);
  for (std::size_t at = 0; at < shown; ++at) {
    out += (at == 0 ? "" : at + 1 == names.size() ? " or " : ", ") + names[at];
  }
  if (shown < names.size()) out += " or one of " + std::to_string(names.size() - shown) + " more";
  return out;
}

}  // namespace

void Library::read(const std::vector<std::string>& files, std::istream& in) {
  for (const std::string& file : files) read_file(file, in);
}

void Library::read_file(const std::string& file, std::istream& in) {
  Result<std::string, Failure> text = text_of_file(file, in);
  if (!text) return errors_.add(about(file, text.error().why));
  const auto found = [this] {
    return definitions_.domains.size() + definitions_.problems.size() +
           definitions_.functions.size() + definitions_.foreign.size() +
           wanted_.passed_over.size() + errors_.size();
  };
  const std::size_t before = found();
  const auto include = [&in](const std::string& name, const std::string& from) {
    return included(name, from, in);
  };
  read_definitions({file, std::move(*text)}, store_, include, definitions_,
                   htn::Findings{errors_, wary_ ? &warnings_ : nullptr}, wanted_);
  if (before == found()) {
    warnings_.add(about(file, "defines neither a domain nor a problem"));
  }
}

// Case does not count, as in the files.
std::string Library::folded(const std::string& name) {
  return std::string(store_.name(store_.symbol(name)));
}

const htn::DomainDefinition* Library::domain_of(const htn::ProblemDefinition& problem) {
  const std::string wanted = folded(problem.domain);
  const auto& domains = definitions_.domains;
  const auto found = std::find_if(domains.rbegin(), domains.rend(), [&](const auto& domain) {
    return folded(domain.name) == wanted;
  });
  if (found != domains.rend()) return &*found;
  const auto another = [&](const auto& domain) {
    return folded(domain.name) != folded(domains.front().name);
  };
  if (!domains.empty() && std::none_of(domains.begin(), domains.end(), another)) {
    return &domains.back();
  }
  const htn::Document* document = problem.tasks ? problem.tasks.document : nullptr;
  Diagnostic diagnostic = about(document == nullptr ? "" : document->file,
                                "problem '" + problem.name + "' has no domain");
  if (domains.empty()) {
    diagnostic.expected = "a file with a domain";
  } else if (problem.domain.empty()) {
    diagnostic.expected = "the name of one of the domains read";
  } else {
    diagnostic.message = "problem '" + problem.name + "': unknown domain '" + problem.domain + "'";
    diagnostic.nearest = nearest_name(problem.domain, names_of(domains));
  }
  errors_.add(diagnostic);
  return nullptr;
}

std::vector<ChosenProblem> Library::choose(const std::vector<std::string>& names) {
  std::vector<ChosenProblem> chosen;
  for (const htn::ProblemDefinition& problem : definitions_.problems) {
    const bool wanted =
        names.empty() || std::any_of(names.begin(), names.end(), [&](const std::string& name) {
          return folded(name) == folded(problem.name);
        });
    if (!wanted) continue;
    const htn::DomainDefinition* domain = domain_of(problem);
    if (domain != nullptr) chosen.push_back({&problem, domain});
  }
  report_unknown(names);
  return chosen;
}

// Where nothing else can be planned, a definition in another language is why.
void Library::report_foreign() {
  for (const htn::ForeignDefinition& one : definitions_.foreign) {
    const htn::Document& document = *one.form.document;
    const htn::Place place = htn::place_of(document, (*one.form).begin);
    Diagnostic diagnostic = about(document.file, "this is " + one.language + ", which is not read");
    diagnostic.line = place.line;
    diagnostic.column = place.column;
    diagnostic.expected =
        "SHOP2's (defdomain …) and (defproblem …)" +
        std::string(one.language == "HDDL" ? ", as a translator (pandaPIparser) writes them" : "");
    const bool nothing = definitions_.problems.empty() && wanted_.passed_over.empty();
    (nothing ? errors_ : warnings_).add(std::move(diagnostic));
  }
}

void Library::report_unknown(const std::vector<std::string>& names) {
  std::vector<std::string> known = names_of(definitions_.problems);
  known.insert(known.end(), wanted_.passed_over.begin(), wanted_.passed_over.end());
  report_foreign();
  if (known.empty() && errors_.empty()) {
    errors_.add(
        about("", "no problem in these files; expected (defproblem …) or (make-problem …)"));
  }
  for (const std::string& name : names) {
    const bool found = std::any_of(known.begin(), known.end(), [&](const std::string& one) {
      return folded(one) == folded(name);
    });
    if (found || known.empty()) continue;
    Diagnostic diagnostic = about("", "no problem is called '" + name + "'");
    diagnostic.expected = listed(known);
    diagnostic.nearest = nearest_name(name, known);
    errors_.add(diagnostic);
  }
}

void Library::compile(const std::vector<ChosenProblem>& problems) {
  const bool sound = errors_.empty();
  for (const ChosenProblem& problem : problems) compiled(*problem.domain);
  if (sound) return;
  for (const htn::DomainDefinition& domain : definitions_.domains) compiled(domain);
}

void Library::check_tasks(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  const auto add = [&](htn::Expression head) {
    if (!head) return;
    const htn::Node& node = *head;
    const htn::Document& document = *head.document;
    const htn::Term name = node.list ? document[node.first_child].atom : node.atom;
    if (name.is(htn::TermKind::kSymbol)) known.emplace_back(store_.name(name));
  };
  for (const htn::DomainDefinition& domain : definitions_.domains) {
    for (const htn::MethodDefinition& made : domain.methods) add(made.head);
    for (const htn::OperatorDefinition& made : domain.operators) {
      add(made.head);
      if (made.action && !known.back().starts_with('!')) known.back().insert(0, "!");
    }
  }
  for (const std::string& name : names) {
    const std::string wanted(store_.name(store_.symbol(name)));
    if (std::find(known.begin(), known.end(), wanted) != known.end()) continue;
    Diagnostic diagnostic = about("--trace", "no task is called '" + name + "'");
    diagnostic.nearest = nearest_name(wanted, known);
    warnings_.add(std::move(diagnostic));
  }
}

const htn::Domain* Library::compiled(const htn::DomainDefinition& domain) {
  const auto known = compiled_.find(&domain);
  if (known != compiled_.end()) return known->second.get();
  auto made = htn::Domain::compile(domain, definitions_.functions, functions_, store_, errors_);
  return compiled_.emplace(&domain, std::move(made)).first->second.get();
}

}  // namespace skein::plan_tool
