// SPDX-License-Identifier: MIT
#pragma once

#include "sealing/bytes.hpp"

#include <string>

/// Bytes from hexadecimal digits.
inline transport::Bytes hex(const std::string &p_digits) {
	transport::Bytes made;
	for (size_t i = 0; i + 1 < p_digits.size(); i += 2) {
		made.push_back(uint8_t(std::stoul(p_digits.substr(i, 2), nullptr, 16)));
	}
	return made;
}

template <size_t COUNT>
std::array<uint8_t, COUNT> hex_array(const std::string &p_digits) {
	return transport::read_array<COUNT>(hex(p_digits).data());
}

inline bool equal(const transport::View &p_one, const transport::View &p_other) {
	return p_one.size == p_other.size && (p_one.size == 0 || std::memcmp(p_one.data, p_other.data, p_one.size) == 0);
}
