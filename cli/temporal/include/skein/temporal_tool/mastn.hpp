// SPDX-License-Identifier: Apache-2.0
// `skein mastn`: multi-agent temporal networks; generating them, playing them, the experiment.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "skein/temporal_lab/mastn_generator.hpp"

namespace skein::temporal_tool {

/// Source: spec 5.4.
struct MastnGenerateOptions {
  temporal::MastnShape shape;
  temporal::ScenarioOptions scenario;
  std::uint64_t seed = 1;
  std::string out;  ///< file; empty: standard output
};

/// Source: spec 5.5.
struct MastnRunOptions {
  std::string file;       ///< "-": standard input
  std::string algorithm;  ///< cip, dip-g, dip-l or dip-m
  bool delays = false;    ///< messages take time, so that steps meet disturbances still under way
  bool cuts = false;      ///< links between agents are cut and heal
  std::uint64_t seed = 1;
};

/// Source: spec 5.4.
struct MastnBenchOptions {
  std::string out = "out/mastn";  ///< folder, made if need be
  bool quick = false;             ///< fewer and smaller networks; the same claims
  std::uint64_t seed = 1;         ///< of the first network
  // What is not given is as in the paper's experiment (or its quick form). Claims about means gate
  // only with the paper's V, L and share of relaxations, for which their margins are measured.
  std::optional<std::vector<std::uint32_t>> agents{};    ///< N
  std::optional<std::vector<std::uint32_t>> external{};  ///< E
  std::optional<std::uint32_t> nodes{};                  ///< V
  std::optional<std::uint32_t> local{};                  ///< L
  std::optional<std::uint32_t> networks{};               ///< of each parameter set
  std::optional<double> relaxations{};                   ///< share of the steps
};

/// Writes a network with its scenario as JSON. 0; 3: the file cannot be written.
int generate_mastn(const MastnGenerateOptions& options, std::ostream& out, std::ostream& err);

/// Plays all the steps and, after quiescence, prints consistency, bounds [s] (none while
/// inconsistent; null: infinite), messages and checks as one JSON object. 0: played, whether
/// consistent or not; 2: the file cannot be used.
int run_mastn(const MastnRunOptions& options, std::istream& in, std::ostream& out,
              std::ostream& err);

/// Writes mastn.csv, the four plots of figure 5 for both modes, and results.md (table of figure 4,
/// all figures, claims) into the folder; prints the table and the claims; progress on `err`.
/// 0; 1: a claim that gates does not hold; 3: the folder cannot be written.
int bench_mastn(const MastnBenchOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::temporal_tool
