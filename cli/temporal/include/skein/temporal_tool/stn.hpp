// SPDX-License-Identifier: Apache-2.0
// `skein stn`: temporal networks from files; consistency, controllability, execution, pictures.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>

#include "skein/temporal_lab/stnu_generator.hpp"

namespace skein::temporal_tool {

/// What all sub-commands have in common. Source: spec 5.5.
struct StnOptions {
  std::string file;             ///< empty or "-": standard input
  bool json = false;            ///< one JSON object instead of text for people
  bool colour = false;          ///< in the text for people
  bool z_first = false;         ///< no node comes before the origin, as the CSTNU Tool takes it
  std::function<double()> now;  ///< [s], for how long a check takes; absent: 0
};

struct StnCheckOptions {
  StnOptions common;
  bool dates = false;  ///< also the earliest and latest date of every node
};

enum class StnStarts : std::uint8_t { kEarliest, kLatest, kRandom };

struct StnDispatchOptions {
  StnOptions common;
  std::uint64_t seed = 1;                   ///< of durations and starts
  StnStarts starts = StnStarts::kEarliest;  ///< when to execute what may be executed
};

struct StnDrawOptions {
  StnOptions common;
  bool dot = false;  ///< text for Graphviz instead of SVG
  std::string title;
  std::string output;  ///< file; empty: standard output
};

struct StnConvertOptions {
  StnOptions common;
  std::string to;      ///< name of a format
  std::string output;  ///< file; empty: standard output
};

/// A random plan. Source: the family of STNUBenchmark2020.
struct StnGenerateOptions {
  temporal::StnuGeneratorOptions shape;
  std::uint64_t seed = 1;
  std::string to = "json";  ///< name of a format
  std::string output;       ///< file; empty: standard output
};

struct StnDispatchableOptions {
  StnOptions common;
  std::string to = "json";  ///< json or graphml
  std::string output;       ///< file; empty: standard output
};

enum class StnQuestion : std::uint8_t { kConsistent, kControllable };

/// One question about every file of a folder.
struct StnBatchOptions {
  StnOptions common;  ///< `file` is not used
  std::string folder;
  StnQuestion question = StnQuestion::kConsistent;
};

/// Changes of bounds, one after the other, of a network that is kept checked.
struct StnChangesOptions {
  StnOptions common;
  std::string changes;   ///< file
  bool compare = false;  ///< also check each network from scratch, and compare
};

// The formats are told from the content (docs/temporal.md). All return 0: done, and consistent,
// controllable or all requirements kept, where that is asked; 1: it is not; 2: the input or an
// option is wrong, said on `err`; 3: the output file cannot be written.

/// Is it consistent, its uncertain durations taken as if they could be chosen?
int check_stn(const StnCheckOptions& options, std::istream& in, std::ostream& out,
              std::ostream& err);
/// Is it dynamically controllable?
int check_stn_controllability(const StnOptions& options, std::istream& in, std::ostream& out,
                              std::ostream& err);
/// Plays one execution against durations drawn inside their bounds.
int dispatch_stn(const StnDispatchOptions& options, std::istream& in, std::ostream& out,
                 std::ostream& err);
/// Draws it, with its dates if it is consistent and the conflict if it is not controllable.
int draw_stn(const StnDrawOptions& options, std::istream& in, std::ostream& out, std::ostream& err);
/// Writes a network whose options and seed are the same on every machine.
int generate_stn(const StnGenerateOptions& options, std::ostream& out, std::ostream& err);
/// Writes its dispatchable form: what an executor needs that looks at neighbours only.
int write_stn_dispatchable(const StnDispatchableOptions& options, std::istream& in,
                           std::ostream& out, std::ostream& err);
/// 0: yes for every file; 1: no for some; 2: some could not be read, or there is no file.
int check_stn_batch(const StnBatchOptions& options, std::ostream& out, std::ostream& err);
/// The verdict after each change. 0: controllable at the end.
int follow_stn_changes(const StnChangesOptions& options, std::istream& in, std::ostream& out,
                       std::ostream& err);
/// Writes it in another format.
int convert_stn(const StnConvertOptions& options, std::istream& in, std::ostream& out,
                std::ostream& err);

}  // namespace skein::temporal_tool
