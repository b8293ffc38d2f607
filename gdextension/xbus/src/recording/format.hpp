// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// Recordings of raw bytes (docs/recordings.md): what came over a bus or a network, and when.
namespace recording {

/// A file begins with this; records follow, to the end.
constexpr std::array<uint8_t, 8> MAGIC = { 'D', 'M', 'T', 'R', 'A', 'W', '1', '\n' };
/// Bytes in front of each record's payload, little-endian: mark u32, payload size u32, kind u8, 0, stream u16,
/// time u64 (µs of CLOCK_MONOTONIC), checksum of the payload u32, checksum of these bytes u32.
constexpr std::size_t HEAD_SIZE = 28;
constexpr std::size_t MAX_PAYLOAD = 65536;
constexpr uint32_t MARK = 0x524D44A5;
constexpr int MAX_STREAMS = 1024;

enum class Kind : uint8_t {
	FILE_HEAD, ///< Text: what the whole file is.
	STREAM, ///< Text: what the records of a stream come from.
	BUS_IN, ///< Bytes from a device.
	BUS_OUT, ///< Bytes to a device.
	DATAGRAM, ///< One datagram.
	LOST, ///< u64: so many records found no room before this one.
	END, ///< The recording was ended in order.
};
constexpr int KINDS = 7;

/// The CRC-32 of Ethernet and zip.
inline uint32_t crc32(const uint8_t *p_bytes, std::size_t p_size, uint32_t p_before = 0) {
	static const std::array<uint32_t, 256> TABLE = []() {
		std::array<uint32_t, 256> table{};
		for (uint32_t byte = 0; byte < 256; ++byte) {
			uint32_t rest = byte;
			for (int bit = 0; bit < 8; ++bit) {
				rest = (rest & 1U) != 0 ? (rest >> 1U) ^ 0xEDB88320U : rest >> 1U;
			}
			table[byte] = rest;
		}
		return table;
	}();
	uint32_t rest = ~p_before;
	for (std::size_t at = 0; at < p_size; ++at) {
		rest = (rest >> 8U) ^ TABLE[(rest ^ p_bytes[at]) & 0xFFU];
	}
	return ~rest;
}

inline void put_little(uint64_t p_value, std::size_t p_size, uint8_t *r_bytes) {
	for (std::size_t at = 0; at < p_size; ++at) {
		r_bytes[at] = uint8_t(p_value >> (8 * at));
	}
}

inline uint64_t get_little(const uint8_t *p_bytes, std::size_t p_size) {
	uint64_t value = 0;
	for (std::size_t at = 0; at < p_size; ++at) {
		value |= uint64_t(p_bytes[at]) << (8 * at);
	}
	return value;
}

/// Writes what is in front of a payload.
inline void put_head(Kind p_kind, int p_stream, uint64_t p_time_usec, const uint8_t *p_payload, std::size_t p_size,
		uint8_t *r_head) {
	put_little(MARK, 4, r_head);
	put_little(p_size, 4, r_head + 4);
	r_head[8] = uint8_t(p_kind);
	r_head[9] = 0;
	put_little(uint64_t(p_stream), 2, r_head + 10);
	put_little(p_time_usec, 8, r_head + 12);
	put_little(crc32(p_payload, p_size), 4, r_head + 20);
	put_little(crc32(r_head, 24), 4, r_head + 24);
}

} // namespace recording
