// SPDX-License-Identifier: Apache-2.0
// Files for readers that want a name.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <span>
#include <string>

#include "temporary_folder.hpp"

namespace skein::geodata {

inline void require(bool condition) {
  if (!condition) std::abort();
}

/// The bytes as a file with this ending, in a folder that goes with the process.
inline std::string file_of(std::span<const std::uint8_t> bytes, const std::string& ending) {
  static const testing::TemporaryFolder kFolder;
  const std::string path = (kFolder.path() / ("fuzzed" + ending)).string();
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
  return path;
}

}  // namespace skein::geodata
