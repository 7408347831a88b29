// SPDX-License-Identifier: Apache-2.0
// The models of joint tasks of a scenario: a file, and all that it uses.
#include <filesystem>

#include "reading.hpp"
#include "skein/config/parse.hpp"
#include "skein/interaction/read_library.hpp"

namespace skein::scenario {

std::shared_ptr<const interaction::Library> read_interaction(const config::Reader& reader,
                                                             const std::string& folder,
                                                             Diagnostics& problems) {
  if (!reader.present()) return nullptr;
  const std::string file = reader.text();
  if (file.empty()) return nullptr;
  const std::string path = (std::filesystem::path(folder) / file).lexically_normal().string();
  const auto documents = interaction::documents_of(
      {path}, [](const std::string& one) { return config::parse_yaml_file(one); });
  if (!documents) {
    problems.append(documents.error());
    return nullptr;
  }
  auto library = interaction::read_library(*documents);
  if (library) return std::make_shared<const interaction::Library>(std::move(*library));
  problems.append(library.error());
  return nullptr;
}

}  // namespace skein::scenario
