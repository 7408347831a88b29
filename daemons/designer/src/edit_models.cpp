// SPDX-License-Identifier: Apache-2.0
#include "skein/designer/edit_models.hpp"

#include <filesystem>
#include <memory>
#include <ostream>

#include "skein/console/console.hpp"
#include "skein/designer/workbench.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/node/waker.hpp"

namespace skein::designer {

int edit_models(const EditOptions& options, std::ostream& out, std::ostream& err) {
  for (const std::string& file : options.files) {
    std::error_code error;
    const bool folder_there =
        std::filesystem::is_directory(std::filesystem::absolute(file, error).parent_path(), error);
    const bool other_thing =
        std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error);
    if (folder_there && !other_thing) continue;
    err << file << ": no file can be there\n";
    return kExitBadInput;
  }
  console::ConsoleConfig config;
  config.port = options.port;
  config.annex = std::make_shared<Workbench>(options.files);
  config.start = "designer.html";
  node::Waker waker;  // before the page's thread: it blocks signals for it too
  auto page = console::Console::open(std::move(config));
  if (!page) {
    err << page.error().why << '\n';
    return kExitSystem;
  }
  out << "designer at " << (*page)->url() << std::endl;
  while (!waker.stop_requested()) waker.wait(Duration::seconds(1));
  return kExitOk;
}

}  // namespace skein::designer
