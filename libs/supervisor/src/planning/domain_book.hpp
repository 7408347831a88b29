// SPDX-License-Identifier: Apache-2.0
// A planning domain, read and compiled, with its term store.
#pragma once

#include <memory>
#include <string>

#include "skein/foundation/diagnostics.hpp"
#include "skein/htn/domain.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// Serves one search after another: domain, problems and plans share one term store. Not movable,
/// since the compiled domain points into it.
class DomainBook {
 public:
  /// Errors of the domain are in errors().
  DomainBook(const DomainText& text, const htn::Functions& functions);
  DomainBook(const DomainBook&) = delete;
  DomainBook& operator=(const DomainBook&) = delete;

  const Diagnostics& errors() const { return errors_; }
  const htn::DomainDefinition* definition() const {
    return definitions_.domains.empty() ? nullptr : &definitions_.domains.front();
  }
  const htn::Domain* compiled() const { return domain_.get(); }
  htn::TermStore& store() { return store_; }

 private:
  void read(const DomainText& text);

  htn::TermStore store_;
  htn::Definitions definitions_;
  std::shared_ptr<htn::Domain> domain_;
  Diagnostics errors_;
};

}  // namespace skein::supervisor
