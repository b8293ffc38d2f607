// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace cueing {

/// Writes numbers one after the other, lowest byte first.
class LittleEndianWriter {
public:
	explicit LittleEndianWriter(uint8_t *r_bytes) : _bytes(r_bytes) {}

	void put_u8(uint8_t p_value) { put(p_value, 1); }
	void put_u16(uint16_t p_value) { put(p_value, 2); }
	void put_u32(uint32_t p_value) { put(p_value, 4); }
	void put_u64(uint64_t p_value) { put(p_value, 8); }
	void put_i32(int32_t p_value) { put(uint32_t(p_value), 4); }
	void put_f32(double p_value) {
		const auto value = float(p_value);
		uint32_t bits = 0;
		std::memcpy(&bits, &value, sizeof(bits));
		put(bits, 4);
	}
	std::size_t size() const { return _size; }

private:
	void put(uint64_t p_value, int p_count) {
		for (int i = 0; i < p_count; i++) {
			_bytes[_size++] = uint8_t(p_value >> (8 * i));
		}
	}

	uint8_t *_bytes;
	std::size_t _size = 0;
};

/// The CRC-32 of Ethernet and zip.
inline uint32_t crc32(const uint8_t *p_bytes, std::size_t p_size) {
	uint32_t rest = 0xffffffffU;
	for (std::size_t i = 0; i < p_size; i++) {
		rest ^= p_bytes[i];
		for (int bit = 0; bit < 8; bit++) {
			rest = (rest >> 1) ^ ((rest & 1U) != 0 ? 0xedb88320U : 0U);
		}
	}
	return ~rest;
}

} // namespace cueing
