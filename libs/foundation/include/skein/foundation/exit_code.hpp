// SPDX-License-Identifier: Apache-2.0
// Exit codes of every program: docs/exit-codes.md has the same table.
#pragma once

namespace skein {

inline constexpr int kExitOk = 0;  ///< done; all expectations met
inline constexpr int kExitNegative =
    1;  ///< done, with a negative result: an expectation not met, …
inline constexpr int kExitBadInput = 2;   ///< wrong usage or wrong input; nothing was started
inline constexpr int kExitSystem = 3;     ///< a daemon died, DDS or the system refused something
inline constexpr int kExitTimeout = 4;    ///< what was waited for did not come in time
inline constexpr int kExitInternal = 70;  ///< a defect in Skein
inline constexpr int kExitInterrupted = 130;  ///< stopped by Ctrl-C

}  // namespace skein
