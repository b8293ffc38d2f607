// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace emulator {

/// Microseconds of a clock that never goes back. The emulator reads no clock: the time is passed in, so that
/// a test runs an hour in a moment.
using Usec = int64_t;

constexpr Usec SECOND = 1000000;
constexpr Usec NEVER = INT64_MAX;

} // namespace emulator
