// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace wire {

/// Ticks that are not.
constexpr uint32_t NEVER = UINT32_MAX;

} // namespace wire
