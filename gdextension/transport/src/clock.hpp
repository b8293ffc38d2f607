// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>

namespace transport {

/// Time of a clock that is never set, us.
inline int64_t now_usec() {
	const auto now = std::chrono::steady_clock::now().time_since_epoch();
	return std::chrono::duration_cast<std::chrono::microseconds>(now).count();
}

} // namespace transport
