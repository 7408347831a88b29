// SPDX-License-Identifier: Apache-2.0
// An XML text as elements that know where they stand. No document type, so no entities to expand.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"

namespace skein::xml {

struct Element {
  std::string name;  ///< as written, with its prefix
  std::vector<std::pair<std::string, std::string>> attributes;
  std::string text;  ///< all of it that stands directly in the element
  std::vector<Element> children;
  int line = 0;    ///< from 1
  int column = 0;  ///< from 1

  /// Null when it is missing.
  const std::string* attribute(std::string_view attribute_name) const;
};

/// Whether the text is in the encoding that it declares, or in UTF-8 whatever it declares.
enum class Encoding { kDeclared, kUtf8 };

struct Limits {
  std::size_t deepest = 16;
  std::size_t most_elements = 1'000'000;
};

/// The root; or why there is none: text that is not well formed, a document type, more nesting or
/// elements than the limits, 2 GB of it. `file` is only used in the message. Cost: linear.
Result<Element, Diagnostic> parse(std::string_view text, const std::string& file,
                                  Encoding encoding = Encoding::kDeclared, Limits limits = {});

}  // namespace skein::xml
