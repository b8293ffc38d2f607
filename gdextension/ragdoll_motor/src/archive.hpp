// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace ragdoll {

/// Collects values as bytes: how a simulation's state is saved for a replay. The bytes are those of
/// this machine and this version; they are no exchange format.
class ArchiveWriter {
public:
	template <class T>
	void put(const T &p_value) {
		static_assert(std::is_trivially_copyable_v<T>, "only plain values can be archived");
		const std::size_t begin = bytes.size();
		bytes.resize(begin + sizeof(T));
		std::memcpy(bytes.data() + begin, &p_value, sizeof(T));
	}
	template <class T>
	void put_all(const std::vector<T> &p_values) {
		put(std::uint32_t(p_values.size()));
		for (const T &value : p_values) {
			put(value);
		}
	}
	const std::vector<std::uint8_t> &get_bytes() const { return bytes; }

private:
	std::vector<std::uint8_t> bytes;
};

/// Reads such bytes. After the first value that is not there every further one is refused.
class ArchiveReader {
public:
	ArchiveReader(const std::uint8_t *p_bytes, std::size_t p_size) : bytes(p_bytes), size(p_size) {}

	template <class T>
	bool get(T &r_value) {
		static_assert(std::is_trivially_copyable_v<T>, "only plain values can be archived");
		if (!good || size - at < sizeof(T)) {
			good = false;
			return false;
		}
		std::memcpy(&r_value, bytes + at, sizeof(T));
		at += sizeof(T);
		return true;
	}
	/// Reads as many values as the vector has; refuses any other number.
	template <class T>
	bool get_all(std::vector<T> &r_values) {
		std::uint32_t count = 0;
		if (!get(count) || count != r_values.size()) {
			good = false;
			return false;
		}
		for (T &value : r_values) {
			get(value);
		}
		return good;
	}
	bool is_good() const { return good; }
	bool is_at_end() const { return at == size; }

private:
	const std::uint8_t *bytes;
	std::size_t size;
	std::size_t at = 0;
	bool good = true;
};

/// FNV-1a, 64 bits: a fingerprint of a simulation's state.
class StateHash {
public:
	template <class T>
	void add(const T &p_value) {
		static_assert(std::is_trivially_copyable_v<T>, "only plain values have a fingerprint");
		std::uint8_t raw[sizeof(T)];
		std::memcpy(raw, &p_value, sizeof(T));
		for (const std::uint8_t byte : raw) {
			value = (value ^ byte) * 1099511628211ULL;
		}
	}
	std::uint64_t get() const { return value; }

private:
	std::uint64_t value = 14695981039346656037ULL;
};

} // namespace ragdoll
