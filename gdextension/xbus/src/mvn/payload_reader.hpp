// SPDX-License-Identifier: MIT
#pragma once

#include "bus/bytes.hpp"
#include "mvn/stranger_text.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace mvn {

/// Reads big-endian numbers and texts one after the other; beyond the end it reads zeros and notes it.
class PayloadReader {
public:
	PayloadReader(const uint8_t *p_bytes, std::size_t p_size) : _at(p_bytes), _left(p_size) {}

	std::size_t left() const { return _left; }
	bool has_failed() const { return _failed; }
	/// Whether all real numbers that were read are finite.
	bool is_finite() const { return _finite; }

	uint8_t read_u8() {
		const uint8_t *bytes = take(1);
		return bytes != nullptr ? *bytes : uint8_t(0);
	}
	uint16_t read_u16() {
		const uint8_t *bytes = take(2);
		return bytes != nullptr ? xbus::read_u16(bytes) : uint16_t(0);
	}
	uint32_t read_u32() {
		const uint8_t *bytes = take(4);
		return bytes != nullptr ? xbus::read_u32(bytes) : 0U;
	}
	int32_t read_i32() { return int32_t(read_u32()); }
	float read_float() {
		const uint32_t bits = read_u32();
		float value = 0.0F;
		std::memcpy(&value, &bits, sizeof(value));
		_finite = _finite && std::isfinite(value);
		return value;
	}
	std::array<float, 3> read_vector() { return { read_float(), read_float(), read_float() }; }
	std::array<float, 4> read_quaternion() { return { read_float(), read_float(), read_float(), read_float() }; }

	/// A text with its length in front.
	std::string read_text(int p_most) {
		const int32_t size = read_i32();
		if (size < 0 || size > p_most || std::size_t(size) > _left) {
			_failed = true;
			return "";
		}
		const uint8_t *bytes = take(std::size_t(size));
		return bytes != nullptr ? clean(bytes, std::size_t(size)) : "";
	}
	/// All that is left, as text.
	std::string read_rest() {
		const std::size_t size = _left;
		const uint8_t *bytes = take(size);
		return bytes != nullptr ? clean(bytes, size, true) : "";
	}

private:
	const uint8_t *take(std::size_t p_size) {
		if (_failed || p_size > _left) {
			_failed = true;
			_left = 0;
			return nullptr;
		}
		const uint8_t *bytes = _at;
		_at += p_size;
		_left -= p_size;
		return bytes;
	}

	static std::string clean(const uint8_t *p_bytes, std::size_t p_size, bool p_keeps_lines = false) {
		return clean_text(reinterpret_cast<const char *>(p_bytes), p_size, p_keeps_lines);
	}

	const uint8_t *_at;
	std::size_t _left;
	bool _failed = false;
	bool _finite = true;
};

} // namespace mvn
