// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

// Numbers as they lie on the bus: big-endian, at any address.

namespace xbus {

inline uint8_t read_u8(const uint8_t *p_bytes) {
	return *p_bytes;
}

inline uint16_t read_u16(const uint8_t *p_bytes) {
	return uint16_t((uint32_t(p_bytes[0]) << 8U) | p_bytes[1]);
}

inline uint32_t read_u32(const uint8_t *p_bytes) {
	return (uint32_t(p_bytes[0]) << 24U) | (uint32_t(p_bytes[1]) << 16U) | (uint32_t(p_bytes[2]) << 8U) | p_bytes[3];
}

inline uint64_t read_u64(const uint8_t *p_bytes) {
	return (uint64_t(read_u32(p_bytes)) << 32U) | read_u32(p_bytes + 4);
}

inline int32_t read_i32(const uint8_t *p_bytes) {
	return int32_t(read_u32(p_bytes));
}

inline void write_u16(uint16_t p_value, uint8_t *r_bytes) {
	r_bytes[0] = uint8_t(uint32_t(p_value) >> 8U);
	r_bytes[1] = uint8_t(p_value);
}

inline void write_u32(uint32_t p_value, uint8_t *r_bytes) {
	write_u16(uint16_t(p_value >> 16U), r_bytes);
	write_u16(uint16_t(p_value), r_bytes + 2);
}

inline void write_u64(uint64_t p_value, uint8_t *r_bytes) {
	write_u32(uint32_t(p_value >> 32U), r_bytes);
	write_u32(uint32_t(p_value), r_bytes + 4);
}

/// Sum of all bytes modulo 256.
inline uint8_t sum_bytes(const uint8_t *p_bytes, std::size_t p_size) {
	// Eight bytes at a time, in four lanes of 16 bits: a lane holds 128 words before it could overflow.
	constexpr uint64_t LANES = 0x00FF00FF00FF00FFULL;
	constexpr std::size_t BLOCK = std::size_t(128) * 8;
	uint32_t sum = 0;
	while (p_size >= 8) {
		const std::size_t block = (p_size < BLOCK ? p_size : BLOCK) / 8 * 8;
		uint64_t lanes = 0;
		for (std::size_t i = 0; i < block; i += 8) {
			uint64_t word = 0;
			std::memcpy(&word, p_bytes + i, 8);
			lanes += (word & LANES) + ((word >> 8U) & LANES);
		}
		// Only low bytes count in the end, and each lane's low byte is at the bottom once.
		sum += uint32_t(lanes) + uint32_t(lanes >> 16U) + uint32_t(lanes >> 32U) + uint32_t(lanes >> 48U);
		p_bytes += block;
		p_size -= block;
	}
	for (std::size_t i = 0; i < p_size; i++) {
		sum += p_bytes[i];
	}
	return uint8_t(sum);
}

} // namespace xbus
