// SPDX-License-Identifier: Apache-2.0
#include "planning/domain_book.hpp"

#include "skein/supervisor/domain_warnings.hpp"

namespace skein::supervisor {

namespace {

Result<std::string, Failure> no_files(const std::string& /*name*/, const std::string& /*from*/) {
  return failure("a planning domain is one file");
}

Diagnostic about(const std::string& file, std::string message, std::string expected) {
  Diagnostic diagnostic;
  diagnostic.file = file;
  diagnostic.message = std::move(message);
  diagnostic.expected = std::move(expected);
  return diagnostic;
}

}  // namespace

DomainBook::DomainBook(const DomainText& text, const htn::Functions& functions) {
  read(text);
  if (definitions_.domains.size() != 1) {
    errors_.add(about(text.file,
                      std::to_string(definitions_.domains.size()) + " planning domains in it",
                      "one (defdomain NAME (…))"));
    // Read again for what was left out: (defdomian …).
    if (definitions_.domains.empty()) errors_.append(warnings_of(text));
    return;
  }
  domain_ = htn::Domain::compile(definitions_.domains.front(), definitions_.functions, functions,
                                 store_, errors_);
  if (!errors_.empty()) domain_.reset();
}

void DomainBook::read(const DomainText& text) {
  htn::read_definitions({text.file, text.text}, store_, no_files, definitions_, errors_);
}

}  // namespace skein::supervisor
