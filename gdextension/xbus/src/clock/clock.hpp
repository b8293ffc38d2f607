// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>

/// The one clock of everything that comes in: CLOCK_MONOTONIC, which no one sets.
namespace clocks {

/// Now, µs of CLOCK_MONOTONIC.
inline uint64_t now_usec() {
	using namespace std::chrono;
	return uint64_t(duration_cast<microseconds>(steady_clock::now().time_since_epoch()).count());
}

/// Unix time minus that clock, µs.
inline int64_t unix_ahead_usec() {
	using namespace std::chrono;
	const auto unix = duration_cast<microseconds>(system_clock::now().time_since_epoch()).count();
	return int64_t(unix) - int64_t(now_usec());
}

} // namespace clocks
