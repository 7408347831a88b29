// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/read_library.hpp"

#include <utility>

#include "library_reader.hpp"

namespace skein::interaction {

namespace {

using config::Reader;

class LibraryReader {
 public:
  Result<Library, Diagnostics> read(const std::vector<Document>& documents) {
    std::vector<Reader> roots;
    for (const Document& one : documents) {
      roots.emplace_back(one.value, one.file, problems_);
      if (!roots.back().is_map()) roots.back().error("no library", "roles, scms, models, …");
      roots.back().keys({"uses", "tasks", "functions", "scms", "roles", "models"});
      for (const Reader& used : roots.back().optional("uses").items()) (void)used.text();
    }
    // Each kind over all documents, so that their order does not matter.
    declare(roots, "tasks", library_.tasks,
            [](const std::string&, const Reader& at) { return read_parameters(at, true); });
    declare(roots, "functions", library_.functions,
            [](const std::string&, const Reader& at) { return read_function(at); });
    declare(roots, "scms", library_.scms, read_scm);
    declare(roots, "roles", library_.roles, [&](const std::string& name, const Reader& at) {
      return read_role(name, at, library_, problems_);
    });
    declare(roots, "models", library_.models,
            [&](const std::string& name, const Reader& at) { return read_model(name, at); });
    if (!problems_.empty()) return tl::unexpected<Diagnostics>(std::move(problems_));
    return std::move(library_);
  }

 private:
  template <class Value, class Read>
  void declare(const std::vector<Reader>& roots, const char* kind,
               std::map<std::string, Value>& into, const Read& read) {
    for (const Reader& root : roots) {
      for (const auto& [name, at] : root.optional(kind).entries()) {
        if (name.empty()) at.error("an empty name", "a name");
        const auto [place, is_new] = into.try_emplace(name);
        if (!is_new) at.error("'" + name + "' is defined twice", "a name of its own");
        place->second = read(name, at);
      }
    }
  }

  Model read_model(const std::string& name, const Reader& reader) {
    reader.keys({"variants"});
    Model model;
    model.task = name;
    const Reader variants = reader.required("variants");
    for (const auto& [variant, at] : variants.entries()) {
      model.variants.push_back(read_variant(variant, at, library_));
      // One type of joint tasks has one list of parameters.
      if (model.variants.back().parameters != model.variants.front().parameters) {
        at.optional("parameters")
            .error("other parameters than variant '" + model.variants.front().name + "'",
                   "the same parameters in all variants");
      }
    }
    if (variants.is_map() && model.variants.empty()) {
      variants.error("no variants", "at least one");
    }
    return model;
  }

  Library library_;
  Diagnostics problems_;
};

}  // namespace

std::vector<std::string> uses_of(const Document& document) {
  std::vector<std::string> files;
  Diagnostics ignored;  // read_library() says what is wrong with it
  const Reader uses = Reader(document.value, document.file, ignored).optional("uses");
  for (const Reader& one : uses.items()) files.push_back(one.text());
  return files;
}

Result<Library, Diagnostics> read_library(const std::vector<Document>& documents) {
  return LibraryReader().read(documents);
}

}  // namespace skein::interaction
