// SPDX-License-Identifier: Apache-2.0
// The types of the wire as other programs read them.
#pragma once

#include <string>
#include <string_view>

namespace skein::spy_tool {

/// Of idl/, all files one after the other.
extern const char* const kIdlText;

/// The definition of a type of `idl` and of all that it is made of, each once, what is used before
/// what uses it, in their module: a text that needs no other file. Empty if there is no such type.
std::string idl_of(std::string_view type, std::string_view idl = kIdlText);

}  // namespace skein::spy_tool
