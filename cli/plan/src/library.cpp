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

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  return text;
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

}  // namespace

void Library::read(const std::vector<std::string>& files, std::istream& in) {
  for (const std::string& file : files) read_file(file, in);
}

void Library::read_file(const std::string& file, std::istream& in) {
  Result<std::string, Failure> text = text_of_file(file, in);
  if (!text) return errors_.add(about(file, text.error().why));
  const std::size_t before = definitions_.domains.size() + definitions_.problems.size() +
                             definitions_.functions.size() + errors_.size();
  read_definitions(
      {file, std::move(*text)}, store_,
      [&in](const std::string& name, const std::string& from) { return included(name, from, in); },
      definitions_, errors_, warnings_);
  const std::size_t after = definitions_.domains.size() + definitions_.problems.size() +
                            definitions_.functions.size() + errors_.size();
  if (before == after) {
    warnings_.add(about(file, "defines neither a domain nor a problem"));
  }
}

const htn::DomainDefinition* Library::domain_of(const htn::ProblemDefinition& problem) {
  const std::string wanted = lower(problem.domain);
  const auto& domains = definitions_.domains;
  const auto found = std::find_if(domains.rbegin(), domains.rend(),
                                  [&](const auto& domain) { return lower(domain.name) == wanted; });
  if (found != domains.rend()) return &*found;
  const auto another = [&](const auto& domain) {
    return lower(domain.name) != lower(domains.front().name);
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
          return lower(name) == lower(problem.name);
        });
    if (!wanted) continue;
    const htn::DomainDefinition* domain = domain_of(problem);
    if (domain != nullptr) chosen.push_back({&problem, domain});
  }
  report_unknown(names);
  return chosen;
}

void Library::report_unknown(const std::vector<std::string>& names) {
  const std::vector<std::string> known = names_of(definitions_.problems);
  if (known.empty() && errors_.empty()) {
    errors_.add(
        about("", "no problem in these files; expected (defproblem …) or (make-problem …)"));
  }
  for (const std::string& name : names) {
    const bool found = std::any_of(known.begin(), known.end(), [&](const std::string& one) {
      return lower(one) == lower(name);
    });
    if (found || known.empty()) continue;
    Diagnostic diagnostic = about("", "no problem is called '" + name + "'");
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

const htn::Domain* Library::compiled(const htn::DomainDefinition& domain) {
  const auto known = compiled_.find(&domain);
  if (known != compiled_.end()) return known->second.get();
  auto made = htn::Domain::compile(domain, definitions_.functions, functions_, store_, errors_);
  return compiled_.emplace(&domain, std::move(made)).first->second.get();
}

}  // namespace skein::plan_tool
