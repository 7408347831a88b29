// SPDX-License-Identifier: Apache-2.0
// A planning domain read and compiled, with all it stands on.
#pragma once

#include <memory>
#include <string>

#include "skein/foundation/diagnostics.hpp"
#include "skein/htn/domain.hpp"
#include "skein/supervisor/planning.hpp"

namespace skein::supervisor {

/// For one search: terms are shared among domain, problem and plan. Not movable: what is compiled
/// points into it.
class DomainBook {
 public:
  /// What is wrong is in errors().
  DomainBook(const DomainText& text, const htn::Functions& functions);
  DomainBook(const DomainBook&) = delete;
  DomainBook& operator=(const DomainBook&) = delete;

  const Diagnostics& errors() const { return errors_; }
  const htn::DomainDefinition* definition() const {
    return definitions_.domains.empty() ? nullptr : &definitions_.domains.front();
  }
  const htn::Domain* compiled() const { return domain_.get(); }
  htn::TermStore& store() { return store_; }
  /// Null, with errors(), when it makes no sense.
  std::unique_ptr<htn::Problem> problem(const std::string& text);

 private:
  void read(const DomainText& text);

  htn::TermStore store_;
  htn::Definitions definitions_;
  std::shared_ptr<htn::Domain> domain_;
  Diagnostics errors_;
};

}  // namespace skein::supervisor
