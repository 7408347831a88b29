// SPDX-License-Identifier: Apache-2.0
// An XML text as elements, with the problems of a reading.
#pragma once

#include <optional>
#include <string_view>

#include "problems.hpp"
#include "skein/xml/element.hpp"

namespace skein::temporal {

using XmlElement = xml::Element;
using XmlEncoding = xml::Encoding;

inline Place place_of(const XmlElement& element) { return {element.line, element.column, ""}; }

/// The root; nothing, and a problem, when there is none (xml::parse).
std::optional<XmlElement> parse_xml(std::string_view text, Problems& problems,
                                    XmlEncoding encoding = XmlEncoding::kDeclared);

}  // namespace skein::temporal
