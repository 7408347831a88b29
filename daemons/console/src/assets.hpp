// SPDX-License-Identifier: Apache-2.0
// The files of the page, embedded when Skein is built.
#pragma once

#include <string_view>

namespace skein::console {

struct Asset {
  std::string_view path;  ///< "/app.js"
  std::string_view type;  ///< of its content
  std::string_view bytes;
};

/// Null: there is no such file.
const Asset* find_asset(std::string_view path);

}  // namespace skein::console
