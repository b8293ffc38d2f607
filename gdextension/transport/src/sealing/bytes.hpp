// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace transport {

using Bytes = std::vector<uint8_t>;

/// Bytes of somebody else.
struct View {
	const uint8_t *data = nullptr;
	size_t size = 0;

	View() = default;
	View(const uint8_t *p_data, size_t p_size) : data(p_data), size(p_size) {}
	View(const Bytes &p_bytes) : data(p_bytes.data()), size(p_bytes.size()) {}
	template <size_t COUNT>
	View(const std::array<uint8_t, COUNT> &p_bytes) : data(p_bytes.data()), size(COUNT) {}

	/// What begins at an offset, which must lie inside.
	View from(size_t p_offset) const { return { data + p_offset, size - p_offset }; }
};

inline void append(Bytes &r_bytes, const View &p_more) {
	r_bytes.insert(r_bytes.end(), p_more.data, p_more.data + p_more.size);
}

inline void append_u32(Bytes &r_bytes, uint32_t p_value) {
	for (int i = 0; i < 4; i++) {
		r_bytes.push_back(uint8_t(p_value >> (8 * i)));
	}
}

inline uint32_t read_u32(const uint8_t *p_from) {
	return uint32_t(p_from[0]) | uint32_t(p_from[1]) << 8 | uint32_t(p_from[2]) << 16 | uint32_t(p_from[3]) << 24;
}

template <size_t COUNT>
std::array<uint8_t, COUNT> read_array(const uint8_t *p_from) {
	std::array<uint8_t, COUNT> made;
	std::memcpy(made.data(), p_from, COUNT);
	return made;
}

} // namespace transport
