// SPDX-License-Identifier: Apache-2.0
// Reads definitions from texts given in a test.
#pragma once

#include <map>
#include <string>

#include "skein/htn/definitions.hpp"

namespace skein::htn::testing {

/// Files by name; what is read and what is reported stays in the object.
class ReaderFixture {
 public:
  ReaderFixture& with_file(const std::string& name, const std::string& text) {
    files_[name] = text;
    return *this;
  }
  ReaderFixture& read(const std::string& text, const std::string& file = "test.lisp") {
    const IncludeReader include = [this](const std::string& name,
                                         const std::string&) -> Result<std::string, Failure> {
      const auto at = files_.find(name);
      if (at == files_.end()) return failure("no such file");
      return at->second;
    };
    read_definitions({file, text}, store, include, definitions, errors, warnings);
    return *this;
  }
  /// A domain "d" with these items.
  ReaderFixture& read_items(const std::string& items) {
    return read("(defdomain d (" + items + "))");
  }

  const DomainDefinition& domain() const { return definitions.domains.at(0); }
  std::string text(Expression expression) const {
    if (!expression) return "";
    const Node& node = *expression;
    return expression.document->text.substr(node.begin, node.end - node.begin);
  }
  std::string error_text() const { return to_text(errors); }
  std::string warning_text() const { return to_text(warnings); }

  TermStore store;
  Definitions definitions;
  Diagnostics errors;
  Diagnostics warnings;

 private:
  std::map<std::string, std::string> files_;
};

/// The expression as Lisp prints it, prefixes written out, without recursion.
inline std::string printed(const Document& document, NodeIndex root, const TermStore& store) {
  struct Open {
    NodeIndex next;
    bool dotted;
    bool first;
  };
  std::string out;
  std::vector<Open> open;
  NodeIndex at = root;
  while (true) {
    const Node& node = document[at];
    if (node.list) {
      out += '(';
      open.push_back({node.first_child, node.dotted, true});
    } else {
      out += store.to_text(node.atom);
    }
    while (!open.empty() && open.back().next == kNoNode) {
      out += ')';
      open.pop_back();
    }
    if (open.empty()) return out;
    Open& list = open.back();
    at = list.next;
    list.next = document[at].next;
    if (!list.first) out += list.dotted && list.next == kNoNode ? " . " : " ";
    list.first = false;
  }
}

}  // namespace skein::htn::testing
