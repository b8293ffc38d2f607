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
		const std::size_t begin = _bytes.size();
		_bytes.resize(begin + sizeof(T));
		std::memcpy(_bytes.data() + begin, &p_value, sizeof(T));
	}
	template <class T>
	void put_all(const std::vector<T> &p_values) {
		put(std::uint32_t(p_values.size()));
		for (const T &value : p_values) {
			put(value);
		}
	}
	const std::vector<std::uint8_t> &get_bytes() const { return _bytes; }

private:
	std::vector<std::uint8_t> _bytes;
};

/// Reads the bytes of an ArchiveWriter. Once a value is missing, every further one is refused.
class ArchiveReader {
public:
	ArchiveReader(const std::uint8_t *p_bytes, std::size_t p_size) : _bytes(p_bytes), _size(p_size) {}

	template <class T>
	bool get(T &r_value) {
		static_assert(std::is_trivially_copyable_v<T>, "only plain values can be archived");
		if (!_good || _size - _at < sizeof(T)) {
			_good = false;
			return false;
		}
		std::memcpy(&r_value, _bytes + _at, sizeof(T));
		_at += sizeof(T);
		return true;
	}
	/// Reads as many values as the vector has; refuses any other number.
	template <class T>
	bool get_all(std::vector<T> &r_values) {
		std::uint32_t count = 0;
		if (!get(count) || count != r_values.size()) {
			_good = false;
			return false;
		}
		for (T &value : r_values) {
			get(value);
		}
		return _good;
	}
	bool is_good() const { return _good; }
	bool is_at_end() const { return _at == _size; }

private:
	const std::uint8_t *_bytes;
	std::size_t _size;
	std::size_t _at = 0;
	bool _good = true;
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
			_value = (_value ^ byte) * 1099511628211ULL;
		}
	}
	std::uint64_t get() const { return _value; }

private:
	std::uint64_t _value = 14695981039346656037ULL;
};

} // namespace ragdoll
