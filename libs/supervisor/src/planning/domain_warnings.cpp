// SPDX-License-Identifier: Apache-2.0
#include "skein/supervisor/domain_warnings.hpp"

#include "skein/htn/definitions.hpp"

namespace skein::supervisor {

Diagnostics warnings_of(const DomainText& domain) {
  const auto no_files = [](const std::string&, const std::string&) -> Result<std::string, Failure> {
    return failure("a planning domain is one file");
  };
  htn::TermStore store;
  htn::Definitions definitions;
  Diagnostics errors, warnings;
  htn::read_definitions({domain.file, domain.text}, store, no_files, definitions, errors, warnings);
  return warnings;
}

}  // namespace skein::supervisor
