// SPDX-License-Identifier: Apache-2.0
#include "load_models.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "skein/config/parse.hpp"
#include "skein/config/reader.hpp"
#include "skein/interaction/check_automaton.hpp"
#include "skein/interaction/read_automaton.hpp"
#include "skein/interaction/read_library.hpp"

namespace skein::model_tool {

namespace {

namespace fs = std::filesystem;
using interaction::Document;

class Loader {
 public:
  void load(const std::string& file) {
    if (!seen_.insert(fs::path(file).lexically_normal().string()).second) return;
    auto value = config::parse_yaml_file(file);
    if (!value) {
      unread_ = true;
      return problems_.append(value.error());
    }
    if (value->find("block") != nullptr) return load_automaton(file, *value);
    Document document{file, std::move(*value)};
    const std::vector<std::string> uses = interaction::uses_of(document);
    documents_.push_back(std::move(document));
    for (const std::string& used : uses) {
      load((fs::path(file).parent_path() / used).lexically_normal().string());
    }
  }

  Result<Loaded, Diagnostics> finish() {
    // Without one of the files, half of the names would be unknown.
    if (unread_) return tl::unexpected<Diagnostics>(std::move(problems_));
    auto library = interaction::read_library(documents_);
    if (!library) problems_.append(library.error());
    if (!problems_.empty()) return tl::unexpected<Diagnostics>(std::move(problems_));
    loaded_.library = std::move(*library);
    return std::move(loaded_);
  }

 private:
  void load_automaton(const std::string& file, const config::Value& value) {
    Diagnostics form;
    auto automaton = interaction::read_automaton(config::Reader(value, file, form));
    if (form.empty()) interaction::check_automaton(automaton, file, form);
    problems_.append(form);
    loaded_.automata.push_back(std::move(automaton));
    loaded_.automaton_files.push_back(file);
  }

  std::set<std::string> seen_;
  bool unread_ = false;
  std::vector<Document> documents_;
  Loaded loaded_;
  Diagnostics problems_;
};

}  // namespace

Result<Loaded, Diagnostics> load_models(const std::vector<std::string>& files) {
  Loader loader;
  for (const std::string& file : files) loader.load(file);
  return loader.finish();
}

}  // namespace skein::model_tool
