// SPDX-License-Identifier: Apache-2.0
#include "skein/designer/workbench.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "json.hpp"
#include "scm_grid.hpp"
#include "skein/config/parse.hpp"
#include "skein/console/nesting.hpp"
#include "skein/foundation/fingerprint.hpp"
#include "skein/interaction/read_library.hpp"
#include "skein/model_tool/check_models.hpp"
#include "skein/yaml_edit/edit.hpp"

namespace skein::designer {

namespace {

namespace fs = std::filesystem;
using console::Answer;

constexpr std::size_t kMostBytes = 262'144;  // of one file

std::optional<std::string> read_file(const std::string& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error) || fs::file_size(file, error) > kMostBytes) return {};
  std::ifstream in(file, std::ios::binary);
  if (!in) return {};
  return std::string((std::istreambuf_iterator<char>(in)), {});
}

/// Of what is not there: empty.
std::string hash_on_disk(const std::string& file) {
  const auto text = read_file(file);
  return text ? fingerprint_text(Fingerprint().put(*text).value()) : "";
}

/// Beside it, then in its place: whoever reads sees the old file or the new one, whole.
Result<void, Failure> write_file(const std::string& file, const std::string& text) {
  std::error_code error;
  const fs::path target = fs::weakly_canonical(file, error);
  const fs::path beside = target.string() + ".new";
  std::ofstream out(beside, std::ios::binary | std::ios::trunc);
  out << text;
  out.close();
  const bool written = !out.fail();
  if (written && fs::exists(target, error)) {
    fs::permissions(beside, fs::status(target, error).permissions(), error);
  }
  if (written) fs::rename(beside, target, error);
  if (written && !error) return {};
  std::error_code ignored;
  fs::remove(beside, ignored);
  return failure(file + ": cannot be written");
}

Answer answer_of(unsigned status, const Json& json) {
  return {status, json.dump(-1, ' ', false, Json::error_handler_t::replace)};
}
Answer problem(unsigned status, const std::string& why) {
  return answer_of(status, {{"problems", {why}}});
}

Result<Json, Failure> asked_in(const std::string& body) {
  if (console::is_too_deep(body)) return failure("nested too deeply");
  Json asked = Json::parse(body, nullptr, false);
  if (!asked.is_object()) return failure("expected a JSON object");
  return asked;
}

std::map<std::string, std::string> texts_in(const Json& asked) {
  std::map<std::string, std::string> texts;
  if (!asked.contains("texts") || !asked["texts"].is_object()) return texts;
  for (const auto& [file, text] : asked["texts"].items()) {
    if (text.is_string() && text.get_ref<const std::string&>().size() <= kMostBytes) {
      texts[file] = text.get<std::string>();
    }
  }
  return texts;
}

interaction::ReadFile reader_of(const std::map<std::string, std::string>& texts) {
  return [&texts](const std::string& file) {
    const auto text = texts.find(file);
    return text == texts.end() ? config::parse_yaml_file(file)
                               : config::parse_yaml(text->second, file);
  };
}

std::string absolute(const std::string& file) {
  std::error_code error;
  return fs::weakly_canonical(fs::absolute(file, error), error).string();
}

/// All edits in their order, or why they cannot be made: then nothing is changed.
Result<void, Failure> make(const Json& edits, const std::function<bool(const std::string&)>& may,
                           std::map<std::string, std::string>& texts) {
  if (!edits.is_array()) return failure("edits: expected a list");
  std::map<std::string, std::string> changed = texts;
  for (const Json& one : edits) {
    const bool has_file = one.is_object() && one.contains("file") && one["file"].is_string();
    const std::string file = has_file ? one["file"].get<std::string>() : "";
    if (!may(file)) return failure("'" + file + "' is not edited here");
    const auto edit = edit_of(one);
    if (!edit) return tl::unexpected(edit.error());
    if (!changed.contains(file)) changed[file] = read_file(file).value_or("");
    auto text = yaml_edit::edited(changed[file], *edit);
    if (!text) return failure(file + ": " + text.error().why);
    changed[file] = std::move(*text);
  }
  texts = std::move(changed);
  return {};
}

}  // namespace

Workbench::Workbench(std::vector<std::string> files) : files_(std::move(files)) {
  at_first_ = reached({});
  std::set<std::string> folders;
  for (const std::string& file : at_first_) {
    folders.insert(fs::path(absolute(file)).parent_path().string() + "/");
  }
  folders_.assign(folders.begin(), folders.end());
}

Answer Workbench::answer(const std::string& method, const std::string& path,
                         const std::string& body) {
  const bool asks = method == "POST";
  if (path == "/api/designer/look" && asks) return look(body);
  if (path == "/api/designer/save" && asks) return save(body);
  if (path == "/api/designer/scm" && asks) return hold(body);
  if (path == "/api/designer/disk" && !asks) return disk();
  return problem(404, "nothing is here");
}

// What cannot be read uses nothing, here: what is wrong with it says the check.
std::vector<std::string> Workbench::reached(const Texts& texts) const {
  std::vector<std::string> files;
  const auto read = reader_of(texts);
  (void)interaction::documents_of(files_, [&](const std::string& file) {
    files.push_back(file);
    auto value = read(file);
    return value ? std::move(value) : Result<config::Value, Diagnostics>(config::Value());
  });
  return files;
}

bool Workbench::may_touch(const std::string& file) const {
  if (std::find(at_first_.begin(), at_first_.end(), file) != at_first_.end()) return true;
  const std::string kind = fs::path(file).extension().string();
  if (kind != ".yaml" && kind != ".yml") return false;
  const std::string whole = absolute(file);
  return std::any_of(folders_.begin(), folders_.end(),
                     [&](const std::string& folder) { return whole.starts_with(folder); });
}

Answer Workbench::look(const std::string& body) const {
  const auto asked = asked_in(body);
  if (!asked) return problem(400, asked.error().why);
  Texts texts = texts_in(*asked);
  Json answer{{"files", Json::array()}};
  if (asked->contains("edits")) {
    const auto made =
        make((*asked)["edits"], [this](const std::string& file) { return may_touch(file); }, texts);
    if (!made) answer["refused"] = made.error().why;
  }
  for (const std::string& file : reached(texts)) {
    if (!may_touch(file)) continue;
    const auto saved = read_file(file);
    const auto text = texts.find(file);
    const std::string now = text == texts.end() ? saved.value_or("") : text->second;
    const auto value = config::parse_yaml(now, file);
    answer["files"].push_back({{"name", file},
                               {"text", now},
                               {"disk", hash_on_disk(file)},
                               {"tree", value ? to_json(*value) : Json(nullptr)}});
  }
  answer["check"] = Json::parse(model_tool::check_report(files_, reader_of(texts)));
  return answer_of(200, answer);
}

Answer Workbench::disk() const {
  Json hashes = Json::object();
  for (const std::string& file : reached({})) {
    if (may_touch(file)) hashes[file] = hash_on_disk(file);
  }
  return answer_of(200, {{"files", hashes}});
}

Answer Workbench::save(const std::string& body) const {
  const auto asked = asked_in(body);
  if (!asked) return problem(400, asked.error().why);
  const Json files = asked->value("files", Json::array());
  Json conflicts = Json::array(), hashes = Json::object();
  for (const Json& one : files) {
    const bool whole = one.is_object() && one.contains("name") && one["name"].is_string() &&
                       one.contains("text") && one["text"].is_string() && one.contains("base") &&
                       one["base"].is_string();
    if (!whole) return problem(400, "files: expected name, text and base of each");
    const std::string name = one["name"].get<std::string>();
    if (!may_touch(name)) return problem(403, "'" + name + "' is not edited here");
    if (one["text"].get_ref<const std::string&>().size() > kMostBytes) {
      return problem(413, name + " is too long");
    }
    if (hash_on_disk(name) != one["base"].get<std::string>()) conflicts.push_back(name);
  }
  if (!conflicts.empty()) return answer_of(409, {{"conflicts", conflicts}});
  for (const Json& one : files) {
    const std::string name = one["name"].get<std::string>();
    if (auto written = write_file(name, one["text"].get<std::string>()); !written) {
      return problem(500, written.error().why);
    }
    hashes[name] = hash_on_disk(name);
  }
  return answer_of(200, {{"files", hashes}});
}

Answer Workbench::hold(const std::string& body) const {
  const auto asked = asked_in(body);
  if (!asked) return problem(400, asked.error().why);
  const Texts texts = texts_in(*asked);
  const auto grid = scm_grid(*asked, files_, reader_of(texts));
  if (!grid) return problem(400, grid.error().why);
  return answer_of(200, {{"rows", *grid}});
}

std::vector<std::string> models_of(const std::string& scenario_file) {
  const auto scenario = config::parse_yaml_file(scenario_file);
  const config::Value* const named = scenario ? scenario->find("interaction") : nullptr;
  if (named == nullptr || named->kind != config::Value::Kind::kScalar) return {};
  const fs::path folder = fs::path(scenario_file).parent_path();
  return {(folder / named->scalar).lexically_normal().string()};
}

}  // namespace skein::designer
