// SPDX-License-Identifier: Apache-2.0
#include "write_file.hpp"

#include <fstream>

namespace skein::temporal_tool {

std::optional<Failure> write_file(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file) return Failure{"cannot be written"};
  return std::nullopt;
}

}  // namespace skein::temporal_tool
