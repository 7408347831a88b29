// SPDX-License-Identifier: Apache-2.0
// Edits of values: what a text must say when it has been edited.
#include <algorithm>

#include "skein/foundation/overloaded.hpp"
#include "skein/yaml_edit/edit.hpp"

namespace skein::yaml_edit {

namespace {

using config::Value;

Failure no_such(const Path& path) { return {"there is no " + to_text(path)}; }

Value* find(Value& top, const Path& path, std::size_t depth) {
  Value* value = &top;
  for (std::size_t i = 0; i < depth && value != nullptr; ++i) {
    if (const auto* key = std::get_if<std::string>(&path[i])) {
      const auto entry = std::find_if(value->entries.begin(), value->entries.end(),
                                      [&](const auto& one) { return one.key == *key; });
      value = entry == value->entries.end() ? nullptr : &entry->value;
    } else {
      const std::size_t index = std::get<std::size_t>(path[i]);
      value = index < value->items.size() ? &value->items[index] : nullptr;
    }
  }
  return value;
}

Result<Value, Failure> take_out(Value& top, const Path& path) {
  Value* const value = find(top, path, path.size());
  if (value == nullptr || path.empty()) return tl::unexpected(no_such(path));
  Value taken = std::move(*value);
  Value& around = *find(top, path, path.size() - 1);
  if (const auto* key = std::get_if<std::string>(&path.back())) {
    std::erase_if(around.entries, [&](const auto& one) { return one.key == *key; });
  } else {
    around.items.erase(around.items.begin() +
                       static_cast<std::ptrdiff_t>(std::get<std::size_t>(path.back())));
  }
  return taken;
}

Result<void, Failure> put_in(Value& top, const Insert& edit) {
  Value* const around = find(top, edit.into, edit.into.size());
  if (around == nullptr) return tl::unexpected(no_such(edit.into));
  if (edit.key.empty()) {
    if (around->kind != Value::Kind::kSequence) return failure(to_text(edit.into) + " is no list");
    const std::size_t at = std::min(edit.index, around->items.size());
    around->items.insert(around->items.begin() + static_cast<std::ptrdiff_t>(at), edit.value);
    return {};
  }
  if (around->kind != Value::Kind::kMap) return failure(to_text(edit.into) + " is no map");
  if (around->find(edit.key) != nullptr) {
    return failure(to_text(edit.into) + " has '" + edit.key + "' already");
  }
  const std::size_t at = std::min(edit.index, around->entries.size());
  around->entries.insert(around->entries.begin() + static_cast<std::ptrdiff_t>(at),
                         {edit.key, edit.value});
  return {};
}

Result<void, Failure> change(Value& top, const Set& edit) {
  Value* const value = find(top, edit.path, edit.path.size());
  if (value == nullptr) return tl::unexpected(no_such(edit.path));
  *value = edit.value;
  return {};
}
Result<void, Failure> change(Value& top, const Insert& edit) { return put_in(top, edit); }
Result<void, Failure> change(Value& top, const Remove& edit) {
  if (auto taken = take_out(top, edit.path); !taken) return tl::unexpected(taken.error());
  return {};
}
Result<void, Failure> change(Value& top, const Rename& edit) {
  if (find(top, edit.path, edit.path.size()) == nullptr || edit.path.empty() ||
      !std::holds_alternative<std::string>(edit.path.back())) {
    return tl::unexpected(no_such(edit.path));
  }
  Value& around = *find(top, edit.path, edit.path.size() - 1);
  const std::string& key = std::get<std::string>(edit.path.back());
  if (edit.key.empty()) return failure("a key must not be empty");
  if (edit.key != key && around.find(edit.key) != nullptr) {
    return failure("there is '" + edit.key + "' already");
  }
  for (auto& entry : around.entries) {
    if (entry.key == key) entry.key = edit.key;
  }
  return {};
}
Result<void, Failure> change(Value& top, const Move& edit) {
  const bool inside = edit.into.size() >= edit.path.size() &&
                      std::equal(edit.path.begin(), edit.path.end(), edit.into.begin());
  if (inside) return failure(to_text(edit.path) + " cannot be moved into itself");
  if (edit.path.empty() || !std::holds_alternative<std::size_t>(edit.path.back())) {
    return failure("only items of lists are moved");
  }
  auto taken = take_out(top, edit.path);
  if (!taken) return tl::unexpected(taken.error());
  return put_in(top, {path_without(edit.into, edit.path), edit.index, "", std::move(*taken)});
}

}  // namespace

std::string to_text(const Path& path) {
  std::string text;
  for (const Step& step : path) {
    if (const auto* key = std::get_if<std::string>(&step)) {
      text += (text.empty() ? "" : ".") + *key;
    } else {
      text += "[" + std::to_string(std::get<std::size_t>(step)) + "]";
    }
  }
  return text.empty() ? "the document" : text;
}

// Behind the item in the same list, everything is one place nearer.
Path path_without(Path path, const Path& item) {
  const std::size_t depth = item.size() - 1;
  if (path.size() <= depth || !std::equal(item.begin(), item.end() - 1, path.begin())) return path;
  auto* const index = std::get_if<std::size_t>(&path[depth]);
  const auto* const gone = std::get_if<std::size_t>(&item.back());
  if (index != nullptr && gone != nullptr && *index > *gone) --*index;
  return path;
}

Result<Value, Failure> applied(const Value& document, const Edit& edit) {
  Value result = document;
  const auto changed = std::visit([&](const auto& one) { return change(result, one); }, edit);
  if (!changed) return tl::unexpected(changed.error());
  return result;
}

bool says_same(const Value& a, const Value& b) {
  if (a.kind != b.kind || a.scalar != b.scalar) return false;
  if (a.items.size() != b.items.size() || a.entries.size() != b.entries.size()) return false;
  for (std::size_t i = 0; i < a.items.size(); ++i) {
    if (!says_same(a.items[i], b.items[i])) return false;
  }
  return std::all_of(a.entries.begin(), a.entries.end(), [&](const auto& entry) {
    const Value* other = b.find(entry.key);
    return other != nullptr && says_same(entry.value, *other);
  });
}

}  // namespace skein::yaml_edit
