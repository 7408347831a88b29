// SPDX-License-Identifier: Apache-2.0
// Models under way between the disk and a page. Entry header.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "skein/console/annex.hpp"

namespace skein::designer {

/// Interaction models edited on a page. The texts that are not saved are with the page, which sends
/// them with each question; here is nothing but the disk. So a page that is lost has changed
/// nothing, and two pages know nothing of each other until one saves.
///
/// | path, method | body | answer |
/// |---|---|---|
/// | /api/designer/look, POST | texts {file: text} that differ from the disk, edits [{file, …}] to
/// be made in them | files: text, hash on disk, tree of each; what `skein model check --json` says
/// of them; why the edits cannot be made | | /api/designer/disk, GET | | hashes of the files | |
/// /api/designer/save, POST | files [{name, text, base}]: base is the hash that the page began with
/// | hashes; 409 when a file has another by now, and then none is written | | /api/designer/scm,
/// POST | texts, model, variant, scm, places, numbers and a grid | where in the grid the SCM holds
/// |
///
/// Laws: what look says of texts `skein model check` says of them when they are saved; no file is
/// written that has changed since the page read it; only files that were named, that they use, or
/// below the folders of these are read to the page or written, and only whole.
/// Thread rule: one thread. Source: ADR 28.
class Workbench final : public console::Annex {
 public:
  /// The models to edit; together with all that they use. They need not be right, nor be there.
  explicit Workbench(std::vector<std::string> files);

  console::Answer answer(const std::string& method, const std::string& path,
                         const std::string& body) override;

 private:
  using Texts = std::map<std::string, std::string>;
  console::Answer look(const std::string& body) const;
  console::Answer disk() const;
  console::Answer save(const std::string& body) const;
  console::Answer hold(const std::string& body) const;

  /// The files, and all that they use, as the texts and the disk have it.
  std::vector<std::string> reached(const Texts& texts) const;
  bool may_touch(const std::string& file) const;

  std::vector<std::string> files_;
  std::vector<std::string> at_first_;  ///< reached when it began
  std::vector<std::string> folders_;   ///< absolute, of these
};

/// The models that a scenario names, as it finds them; empty: it names none.
std::vector<std::string> models_of(const std::string& scenario_file);

}  // namespace skein::designer
