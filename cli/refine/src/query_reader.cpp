// SPDX-License-Identifier: Apache-2.0
#include "query_reader.hpp"

#include "questions.hpp"
#include "skein/config/parse.hpp"
#include "skein/world/world_reader.hpp"

namespace skein::refine_tool {
namespace {

using config::Reader;

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const ServiceReader& service : service_readers()) all.emplace_back(service.name);
  return all;
}

std::optional<world::World> read_world(const Reader& reader, const References& references,
                                       Diagnostics& diagnostics) {
  if (!reader.present()) return std::nullopt;
  const std::size_t before = diagnostics.size();
  if (!reader.is_map()) {
    auto world = references.world_in_file(reader.text());
    if (world) return std::move(*world);
    reader.error("the world cannot be read");
    diagnostics.append(world.error());
    return std::nullopt;
  }
  world::WorldFile inside = world::read_world_file(reader);
  if (diagnostics.size() > before) return std::nullopt;
  auto world = references.world_inside(std::move(inside));
  if (world) return std::move(*world);
  diagnostics.append(world.error());
  return std::nullopt;
}

void read_budget(const Reader& reader, Query& query) {
  if (reader.is_scalar()) {
    query.no_budget = reader.text() == "none";
    if (!query.no_budget) reader.error("this is no budget", "{seconds, steps}, or none");
    return;
  }
  if (!reader.present() || !reader.keys({"seconds", "steps"})) return;
  if (const Reader seconds = reader.optional("seconds"); seconds.present())
    query.seconds = seconds.number(1, {0, 86'400, "s"});
  if (const Reader steps = reader.optional("steps"); steps.present())
    query.steps = steps.natural(1);
}

void read_parts(const Reader& reader, const References& references, Diagnostics& diagnostics,
                std::optional<Query>& out) {
  const std::string service =
      reader.required("service").name_among(names(),
                                            "a service: path, tour, coverage, partition, "
                                            "patrol, viewpoint, viewshed, relay, evaluate, "
                                            "insertion");
  auto world = read_world(reader.required("world"), references, diagnostics);
  if (service.empty() || !world) return;
  out.emplace(Query{service, std::move(*world), refiners::PathQuery(), {}, 1, {}, {}});
  out->seed = reader.optional("seed").natural(1);
  read_budget(reader.optional("budget"), *out);
  if (const Reader planner = reader.optional("planner"); planner.present())
    out->planner = static_cast<Planner>(planner.choice({"voxels", "sampling"}));
  const Terms terms(out->world, references, diagnostics, out->notes);
  for (const ServiceReader& candidate : service_readers())
    if (service == candidate.name) out->question = candidate.read(reader, terms);
}

}  // namespace

Result<Query, Diagnostics> read_query(std::string_view text, const std::string& file,
                                      const References& references) {
  const auto document = config::parse_yaml(text, file);
  if (!document) return tl::make_unexpected(document.error());
  Diagnostics diagnostics;
  const Reader reader(*document, file, diagnostics);
  std::optional<Query> query;
  if (!reader.is_map()) {
    reader.error("this is not a query", "a map with service, world and what the service asks for");
  } else {
    read_parts(reader, references, diagnostics, query);
  }
  if (!diagnostics.empty() || !query) return tl::make_unexpected(diagnostics);
  return std::move(*query);
}

}  // namespace skein::refine_tool
