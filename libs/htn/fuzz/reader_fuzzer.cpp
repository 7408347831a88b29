// SPDX-License-Identifier: Apache-2.0
// No text, however wrong, may crash the reader of domains and problems, hang it or make it take
// much memory. Inclusions are answered with the text itself.
#include <cstdint>
#include <string>

#include "skein/foundation/contract.hpp"
#include "skein/htn/definitions.hpp"

namespace {

using namespace skein;
using namespace skein::htn;

// What is promised of every document: children lie inside their list, in order, and end.
void check_shape(const Document& document) {
  for (const Node& node : document.nodes) {
    SKEIN_ENSURES(node.begin <= node.end && node.end <= document.text.size());
    SKEIN_ENSURES(node.list || node.first_child == kNoNode);
  }
  for (NodeIndex at = 0; at < document.nodes.size(); ++at) {
    std::uint32_t reached = document[at].begin;
    for (const NodeIndex child : children(document, at)) {
      SKEIN_ENSURES(document[child].begin >= reached);
      SKEIN_ENSURES(document[child].end <= document[at].end);
      reached = document[child].begin;
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  TermStore store;
  Definitions definitions;
  Diagnostics errors;
  Diagnostics warnings;
  const IncludeReader include = [&text](const std::string& name, const std::string&) {
    return name == "absent.lisp" ? Result<std::string, Failure>(failure("no such file"))
                                 : Result<std::string, Failure>(text.substr(0, 4096));
  };
  read_definitions({"fuzz.lisp", text}, store, include, definitions, errors, warnings);
  for (const auto& document : definitions.documents) check_shape(*document);
  SKEIN_ENSURES(errors.size() <= 201 && warnings.size() <= 201);
  for (const Diagnostic& error : errors.all()) (void)underlined(error, text);
  for (const Diagnostic& warning : warnings.all()) (void)underlined(warning, text);
  return 0;
}
