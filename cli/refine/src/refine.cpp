// SPDX-License-Identifier: Apache-2.0
#include "skein/refine_tool/refine.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>

#include "answer.hpp"
#include "examples.hpp"
#include "features.hpp"
#include "picture.hpp"
#include "query_reader.hpp"
#include "questions.hpp"
#include "result_json.hpp"
#include "result_text.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/geodata/raster_writer.hpp"
#include "skein/geodata/world_loader.hpp"
#include "skein/world/vehicle_model_reader.hpp"

namespace skein::refine_tool {
namespace {

namespace fs = std::filesystem;

/// Patrols go on searching while a goal of theirs is missed, for minutes where it cannot be met:
/// by default that long [s of the processor].
constexpr double kPatrolSeconds = 20;

tl::unexpected<Diagnostics> about(std::string file, std::string message) {
  Diagnostics diagnostics;
  Diagnostic one;
  one.file = std::move(file);
  one.message = std::move(message);
  diagnostics.add(std::move(one));
  return tl::make_unexpected(std::move(diagnostics));
}

Result<std::string, Diagnostics> text_of(const std::string& file, std::istream& in) {
  if (file == "-") return std::string(std::istreambuf_iterator<char>(in), {});
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) return about(file, "there is no such file");
  if (!fs::is_regular_file(status)) return about(file, "is not a file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return about(file, "cannot be read");
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

Result<world::VehicleModel, Diagnostics> vehicle_in(const std::string& file) {
  std::ifstream none;
  const auto text = text_of(file, none);
  if (!text) return tl::make_unexpected(text.error());
  return world::read_vehicle_model(*text, file);
}

/// Files are named from where the query is.
References references_from(const fs::path& folder) {
  return {
      [folder](const std::string& path) { return geodata::read_world((folder / path).string()); },
      [folder](world::WorldFile inside) {
        return geodata::load_world(std::move(inside), folder.string());
      },
      [folder](const std::string& path) { return vehicle_in((folder / path).string()); },
      [folder](const std::string& path, const world::GeodeticOrigin& origin,
               const std::string& crs) {
        return geodata::read_shapes((folder / path).string(), origin, crs);
      }};
}

/// What the command line says comes before the query, and that before the default of patrols.
void take_budget(const RefineOptions& options, Query& query) {
  if (options.no_budget) {
    query.seconds.reset();
    query.steps.reset();
    return;
  }
  if (options.seconds) query.seconds = options.seconds;
  if (query.seconds || query.steps || query.no_budget) return;
  if (!std::holds_alternative<refiners::PatrolQuery>(query.question)) return;
  query.seconds = kPatrolSeconds;
  query.by_default = true;
}

/// Shares are balanced as they are flown.
void take_flights(const RefineOptions& options, Query& query) {
  auto* partition = std::get_if<refiners::PartitionQuery>(&query.question);
  if (partition == nullptr || !options.flown) return;
  partition->flown = [flown = options.flown, world = std::make_shared<world::World>(query.world)](
                         const refiners::Member& member, double altitude,
                         const world::Polygon& part) {
    return flown(member, altitude, part, world);
  };
}

Result<Query, Diagnostics> query_of(const RefineOptions& options, std::istream& in) {
  const auto text = text_of(options.query, in);
  if (!text) return tl::make_unexpected(text.error());
  const bool piped = options.query == "-";
  auto query =
      read_query(*text, piped ? "standard input" : options.query,
                 references_from(piped ? fs::path() : fs::path(options.query).parent_path()));
  if (!query) return query;
  if (options.seed) query->seed = *options.seed;
  take_budget(options, *query);
  take_flights(options, *query);
  return query;
}

std::function<bool()> clock_of(const Query& query, const RefineOptions& options) {
  if (!query.seconds || !options.now) return {};
  return [now = options.now, end = options.now() + *query.seconds] { return now() >= end; };
}

int print_example(const std::string& service, std::ostream& out, std::ostream& err) {
  const std::string text = example_of(service);
  if (!text.empty()) {
    out << text;
    return kExitOk;
  }
  err << "there is no service '" << service << "'; expected one of:";
  for (const std::string& name : service_names()) err << ' ' << name;
  err << did_you_mean(nearest_name(service, service_names())) << '\n';
  return kExitBadInput;
}

bool write_picture(const std::string& file, const Query& query, const Answer& answer,
                   std::ostream& err) {
  std::ofstream out(file, std::ios::binary);
  out << picture_of(query, answer);
  out.close();
  if (out) return true;
  err << file << ": cannot be written\n";
  return false;
}

/// Cells as a raster, where the answer has any and the file is one; else ways, areas and places.
Result<void, Diagnostics> write_answer(const std::string& file, const Query& query,
                                       const Solution& solution) {
  const auto* view = std::get_if<refiners::Refined<refiners::Viewshed>>(&solution);
  if (view == nullptr || !geodata::is_raster_name(file))
    return geodata::write_features(file, features_of(query, solution), query.world.origin);
  std::vector<double> values;
  for (const refiners::Sight sight : view->task.cells)
    values.push_back(sight == refiners::Sight::kLeftOut
                         ? std::numeric_limits<double>::quiet_NaN()
                         : static_cast<double>(sight == refiners::Sight::kSeen));
  return geodata::write_raster(file, view->task.grid, values, query.world.origin);
}

int exit_code_of(const Answer& answer) {
  if (answer) return kExitOk;
  switch (answer.error().kind) {
    case refiners::RefusalKind::kBadQuery:
      return kExitBadInput;
    case refiners::RefusalKind::kBudgetExhausted:
      return kExitTimeout;
    default:
      return kExitNegative;
  }
}

int run(const RefineOptions& options, std::istream& in, std::ostream& out, std::ostream& err) {
  if (!options.example.empty()) return print_example(options.example, out, err);
  auto query = query_of(options, in);
  if (!query) {
    err << to_text(query.error());
    return kExitBadInput;
  }
  const Answer answer = refine_tool::answer(*query, clock_of(*query, options));
  if (options.json) {
    out << to_json(*query, answer).dump(2) << '\n';
  } else {
    write_text(out, *query, answer, options.colour);
  }
  if (!options.svg.empty() && !write_picture(options.svg, *query, answer, err)) return kExitSystem;
  if (!options.out.empty() && answer) {
    const auto written = write_answer(options.out, *query, *answer);
    if (!written) {
      err << to_text(written.error());
      return kExitSystem;
    }
  }
  return exit_code_of(answer);
}

}  // namespace

std::vector<std::string> service_names() {
  std::vector<std::string> names;
  for (const ServiceReader& service : service_readers()) names.emplace_back(service.name);
  return names;
}

int run_refine(const RefineOptions& options, std::istream& in, std::ostream& out,
               std::ostream& err) try {
  return run(options, in, out, err);
} catch (const std::exception& error) {  // of the standard library's streams and memory
  err << "skein refine: " << error.what() << '\n';
  return kExitInternal;
}

}  // namespace skein::refine_tool
