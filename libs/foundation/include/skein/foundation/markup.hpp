// SPDX-License-Identifier: Apache-2.0
// Text inside HTML, SVG and other XML.
#pragma once

#include <string>
#include <string_view>

namespace skein {

/// Text safe inside HTML and XML, as content or as a quoted attribute: markup characters become
/// entities; what XML forbids (control characters, bad UTF-8, U+FFFE, U+FFFF) becomes U+FFFD.
std::string escaped_markup(std::string_view text);

}  // namespace skein
