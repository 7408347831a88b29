// SPDX-License-Identifier: Apache-2.0
#include "skein/interaction/read_library.hpp"

#include <algorithm>
#include <deque>
#include <set>
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

namespace {

/// A path as written in a file, seen from where that file is; without "." and "a/..".
std::string beside(const std::string& file, const std::string& path) {
  const std::size_t folder = path.starts_with("/") ? 0 : file.rfind('/') + 1;
  const std::string whole = file.substr(0, folder) + path;
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= whole.size();) {
    const std::size_t end = std::min(whole.find('/', at), whole.size());
    const std::string part = whole.substr(at, end - at);
    at = end + 1;
    const bool goes_down = !parts.empty() && parts.back() != ".." && !parts.back().empty();
    if (part == ".." && goes_down) {
      parts.pop_back();
    } else if (part != "." && (!part.empty() || parts.empty())) {
      parts.push_back(part);
    }
  }
  std::string result;
  for (std::size_t i = 0; i < parts.size(); ++i) result += (i == 0 ? "" : "/") + parts[i];
  return result;
}

}  // namespace

Result<std::vector<Document>, Diagnostics> documents_of(const std::vector<std::string>& files,
                                                        const ReadFile& read) {
  std::vector<Document> documents;
  Diagnostics problems;
  std::set<std::string> seen;
  std::deque<std::string> open(files.begin(), files.end());
  while (!open.empty()) {
    const std::string file = std::move(open.front());
    open.pop_front();
    if (!seen.insert(beside("", file)).second) continue;
    auto value = read(file);
    if (!value) {
      problems.append(value.error());
      continue;
    }
    documents.push_back({file, std::move(*value)});
    const std::vector<std::string> uses = uses_of(documents.back());
    for (auto used = uses.rbegin(); used != uses.rend(); ++used) {
      open.push_front(beside(file, *used));
    }
  }
  if (!problems.empty()) return tl::unexpected<Diagnostics>(std::move(problems));
  return documents;
}

Result<Library, Diagnostics> read_library(const std::vector<Document>& documents) {
  return LibraryReader().read(documents);
}

}  // namespace skein::interaction
