// SPDX-License-Identifier: Apache-2.0
#include "skein/model_tool/model_files.hpp"

#include "skein/model_tool/check_models.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <ostream>

#include "skein/foundation/exit_code.hpp"
#include "skein/interaction/draw_model.hpp"
#include "skein/model_tool/load_models.hpp"

namespace skein::model_tool {

namespace {

using Json = nlohmann::ordered_json;

Json errors_json(const Diagnostics& problems) {
  Json errors = Json::array();
  for (const Diagnostic& one : problems.all()) {
    Json error{{"file", one.file},
               {"line", one.line},
               {"column", one.column},
               {"path", one.path},
               {"message", one.message}};
    if (!one.expected.empty()) error["expected"] = one.expected;
    if (!one.nearest.empty()) error["nearest"] = one.nearest;
    errors.push_back(std::move(error));
  }
  return errors;
}

Json content_json(const Loaded& loaded) {
  Json roles = Json::array(), scms = Json::array(), models = Json::object();
  for (const auto& [name, role] : loaded.library.roles) roles.push_back(name);
  for (const auto& [name, scm] : loaded.library.scms) scms.push_back(name);
  for (const auto& [task, model] : loaded.library.models) {
    Json variants = Json::array();
    for (const auto& variant : model.variants) variants.push_back(variant.name);
    models[task] = std::move(variants);
  }
  return {
      {"roles", roles}, {"scms", scms}, {"models", models}, {"automata", loaded.automaton_files}};
}

std::string report_of(const Result<Loaded, Diagnostics>& loaded) {
  Json json{{"right", loaded.has_value()}, {"errors", Json::array()}};
  if (loaded) {
    json.update(content_json(*loaded));
  } else {
    json["errors"] = errors_json(loaded.error());
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void write_text(std::ostream& out, const Loaded& loaded) {
  for (const auto& [task, model] : loaded.library.models) {
    for (const auto& variant : model.variants) {
      out << "model " << task << ", variant " << variant.name << ":";
      for (const std::string& role : variant.roles) {
        out << ' ' << role << " × " << to_text(variant.table.arities.at(role))
            << (role == variant.roles.back() ? "\n" : ",");
      }
    }
  }
  for (std::size_t i = 0; i < loaded.automata.size(); ++i) {
    out << "automaton " << loaded.automaton_files[i] << ": " << loaded.automata[i].size()
        << " componels\n";
  }
  out << loaded.library.roles.size() << " roles, " << loaded.library.scms.size() << " SCMs, "
      << loaded.library.models.size() << " models: right\n";
}

}  // namespace

std::string check_report(const std::vector<std::string>& files, const interaction::ReadFile& read) {
  return report_of(load_models(files, read));
}

int check_models(const CheckOptions& options, std::ostream& out, std::ostream& err) {
  const auto loaded = load_models(options.files);
  if (options.json) {
    out << report_of(loaded) << '\n';
  } else if (loaded) {
    write_text(out, *loaded);
  } else {
    err << to_text(loaded.error());
  }
  return loaded ? kExitOk : kExitBadInput;
}

int draw_models(const DrawOptions& options, std::ostream& out, std::ostream& err) {
  const auto loaded = load_models({options.file});
  if (!loaded) {
    err << to_text(loaded.error());
    return kExitBadInput;
  }
  const auto& library = loaded->library;
  if (loaded->automata.empty() && library.models.empty() && library.roles.empty()) {
    err << options.file << ": nothing to draw: no models, roles or automaton in it\n";
    return kExitBadInput;
  }
  const std::string svg = loaded->automata.empty()
                              ? interaction::draw_svg(library)
                              : interaction::draw_svg(loaded->automata.front(), options.file);
  if (options.output.empty() || options.output == "-") {
    out << svg;
    return kExitOk;
  }
  std::ofstream file(options.output, std::ios::binary);
  file << svg;
  if (file.flush()) return kExitOk;
  err << options.output << ": cannot be written\n";
  return kExitSystem;
}

}  // namespace skein::model_tool
