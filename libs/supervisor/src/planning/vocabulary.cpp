// SPDX-License-Identifier: Apache-2.0
// The declarations of a domain: what may be asked, and which device serves what.
#include <algorithm>

#include "planning/domain_book.hpp"
#include "planning/terms.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/htn/syntax.hpp"
#include "skein/supervisor/planner_host.hpp"

namespace skein::supervisor {

namespace {

using htn::NodeIndex;

class Declarations {
 public:
  Declarations(const htn::TermStore& store, const htn::DomainDefinition& domain,
               Diagnostics& errors)
      : store_(store), domain_(domain), errors_(errors) {}

  mission::Vocabulary read() {
    for (const htn::AxiomDefinition& axiom : domain_.axioms) {
      document_ = axiom.head.document;
      const std::vector<NodeIndex> parts = children(*document_, axiom.head.node);
      const std::string name = parts.empty() ? "" : word(parts[0]);
      if (name == "high-level-task") read_task(axiom.head.node, parts);
      if (name == "device-serves") read_device(axiom.head.node, parts);
    }
    return std::move(vocabulary_);
  }

 private:
  void read_task(NodeIndex whole, const std::vector<NodeIndex>& parts) {
    const bool shaped =
        parts.size() == 4 && !word(parts[1]).empty() && is_list(parts[2]) && is_list(parts[3]);
    if (!shaped)
      return complain(whole, "a declaration of another shape",
                      "(high-level-task NAME (KIND…) (USE…))");
    mission::TaskSignature signature{word(parts[1]), {}, {}};
    for (const NodeIndex node : items(parts[2])) {
      if (const auto kind = mission::parameter_kind_from(word(node)))
        signature.parameters.push_back(*kind);
      else
        unknown_kind(node);
    }
    for (const NodeIndex node : items(parts[3])) signature.uses.push_back(word(node));
    check_method(parts[1], signature.name, items(parts[2]).size());
    if (!vocabulary_.tasks.emplace(signature.name, signature).second)
      complain(parts[1], "task '" + signature.name + "' is declared twice", "");
  }

  /// (NAME ARGUMENT… TIME-CONSTRAINTS ORIGIN).
  void check_method(NodeIndex at, const std::string& name, std::size_t arguments) {
    const std::size_t wanted = arguments + 3;
    for (const htn::MethodDefinition& method : domain_.methods) {
      const auto head = children(*method.head.document, method.head.node);
      const htn::Node& first = (*method.head.document)[head.front()];
      if (text_of(store_, first.atom) == name && head.size() == wanted) return;
    }
    complain(at, "no method for the declared task '" + name + "'",
             "(:method (" + name + " with " + std::to_string(arguments) +
                 " arguments, time constraints and origin) …)");
  }

  void read_device(NodeIndex whole, const std::vector<NodeIndex>& parts) {
    if (parts.size() != 3 || word(parts[1]).empty() || word(parts[2]).empty())
      return complain(whole, "a declaration of another shape", "(device-serves DEVICE USE)");
    vocabulary_.serves.emplace(word(parts[1]), word(parts[2]));
  }

  void unknown_kind(NodeIndex node) {
    std::vector<std::string> kinds;
    for (std::uint8_t i = 0; i < static_cast<std::uint8_t>(mission::ParameterKind::kCount); ++i)
      kinds.emplace_back(mission::to_text(static_cast<mission::ParameterKind>(i)));
    complain(node, "unknown kind of argument '" + word(node) + "'", "one of " + joined(kinds, ", "),
             nearest_name(word(node), kinds));
  }

  void complain(NodeIndex node, std::string message, std::string expected,
                std::string nearest = {}) {
    const htn::Place place = place_of(*document_, (*document_)[node].begin);
    errors_.add({document_->file, place.line, place.column, "", std::move(message),
                 std::move(expected), std::move(nearest)});
  }

  bool is_list(NodeIndex node) const {
    const htn::Node& one = (*document_)[node];
    return one.list || one.atom == htn::kNil;
  }
  std::vector<NodeIndex> items(NodeIndex node) const {
    return (*document_)[node].list ? children(*document_, node) : std::vector<NodeIndex>{};
  }
  std::string word(NodeIndex node) const {
    const htn::Node& one = (*document_)[node];
    return one.list ? std::string() : text_of(store_, one.atom);
  }

  const htn::TermStore& store_;
  const htn::DomainDefinition& domain_;
  Diagnostics& errors_;
  const htn::Document* document_ = nullptr;
  mission::Vocabulary vocabulary_;
};

}  // namespace

Result<mission::Vocabulary, Diagnostics> vocabulary_of(const DomainText& domain) {
  htn::Functions functions;
  PlannerHost::declare(functions);
  DomainBook book(domain, functions);
  Diagnostics errors = book.errors();
  mission::Vocabulary vocabulary;
  if (book.definition() != nullptr)
    vocabulary = Declarations(book.store(), *book.definition(), errors).read();
  if (!errors.empty()) return tl::unexpected<Diagnostics>(std::move(errors));
  return vocabulary;
}

}  // namespace skein::supervisor
