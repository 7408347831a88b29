// SPDX-License-Identifier: Apache-2.0
#include "skein/model_tool/load_models.hpp"

#include "skein/config/parse.hpp"
#include "skein/config/reader.hpp"
#include "skein/interaction/check_automaton.hpp"
#include "skein/interaction/read_automaton.hpp"
#include "skein/interaction/read_library.hpp"

namespace skein::model_tool {

namespace {

using interaction::Document;

void load_automaton(const Document& document, Loaded& loaded, Diagnostics& problems) {
  Diagnostics form;
  auto automaton = interaction::read_automaton(config::Reader(document.value, document.file, form));
  if (form.empty()) interaction::check_automaton(automaton, document.file, form);
  problems.append(form);
  loaded.automata.push_back(std::move(automaton));
  loaded.automaton_files.push_back(document.file);
}

}  // namespace

Result<Loaded, Diagnostics> load_models(const std::vector<std::string>& files) {
  return load_models(files, [](const std::string& file) { return config::parse_yaml_file(file); });
}

Result<Loaded, Diagnostics> load_models(const std::vector<std::string>& files,
                                        const interaction::ReadFile& read) {
  auto documents = interaction::documents_of(files, read);
  if (!documents) return tl::unexpected<Diagnostics>(documents.error());
  Loaded loaded;
  Diagnostics problems;
  std::vector<Document> of_library;
  for (Document& one : *documents) {
    if (one.value.find("block") != nullptr) {
      load_automaton(one, loaded, problems);
    } else {
      of_library.push_back(std::move(one));
    }
  }
  auto library = interaction::read_library(of_library);
  if (!library) problems.append(library.error());
  if (!problems.empty()) return tl::unexpected<Diagnostics>(std::move(problems));
  loaded.library = std::move(*library);
  return loaded;
}

}  // namespace skein::model_tool
