// SPDX-License-Identifier: Apache-2.0
#include "xml_document.hpp"

namespace skein::temporal {

std::optional<XmlElement> parse_xml(std::string_view text, Problems& problems,
                                    XmlEncoding encoding) {
  auto root = xml::parse(text, "", encoding);
  if (root) return std::move(*root);
  const Diagnostic& problem = root.error();
  problems.add({problem.line, problem.column, ""}, problem.message, problem.expected);
  return std::nullopt;
}

}  // namespace skein::temporal
