// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/variant/packed_byte_array.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace godot {

inline PackedByteArray to_bytes(const std::vector<uint8_t> &p_bytes) {
	PackedByteArray bytes;
	bytes.resize(int64_t(p_bytes.size()));
	std::copy(p_bytes.begin(), p_bytes.end(), bytes.ptrw());
	return bytes;
}

} // namespace godot
