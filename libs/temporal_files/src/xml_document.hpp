// SPDX-License-Identifier: Apache-2.0
// An XML text as elements that know where they stand. No document type, so no entities to expand.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "problems.hpp"

namespace skein::temporal {

struct XmlElement {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::string text;  ///< all of it that stands directly in the element
  std::vector<XmlElement> children;
  int line = 0;
  int column = 0;

  /// Null when it is missing.
  const std::string* attribute(std::string_view attribute_name) const;
  Place place() const { return {line, column, ""}; }
};

/// Whether the text is in the encoding that it declares, or in UTF-8 whatever it declares.
enum class XmlEncoding { kDeclared, kUtf8 };

/// The root; nothing, and problems, when the text is not well formed, has a document type, nests
/// more than 16 deep or has more than a million elements.
std::optional<XmlElement> parse_xml(std::string_view text, Problems& problems,
                                    XmlEncoding encoding = XmlEncoding::kDeclared);

}  // namespace skein::temporal
