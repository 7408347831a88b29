// SPDX-License-Identifier: Apache-2.0
// `skein stn`: temporal networks from files; consistency, controllability, execution, pictures.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>

namespace skein::temporal_tool {

/// What all sub-commands have in common. Source: spec 5.5.
struct StnOptions {
  std::string file;             ///< empty or "-": standard input
  bool json = false;            ///< one JSON object instead of text for people
  bool colour = false;          ///< in the text for people
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
/// Writes it in another format.
int convert_stn(const StnConvertOptions& options, std::istream& in, std::ostream& out,
                std::ostream& err);

}  // namespace skein::temporal_tool
