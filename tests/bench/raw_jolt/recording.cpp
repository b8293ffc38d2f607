// SPDX-License-Identifier: MIT
#include "recording.hpp"

#include <cstring>
#include <fstream>
#include <iterator>
#include <type_traits>

namespace {

/// Takes values off the beginning of a file's bytes.
class Reader {
public:
	explicit Reader(const std::vector<char> &p_bytes) : bytes(p_bytes) {}

	template <typename T>
	void take(T *r_values, std::size_t p_count) {
		static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(float) == 0);
		const std::size_t size = p_count * sizeof(T);
		if (size > bytes.size() - at) {
			is_short = true;
			return;
		}
		std::memcpy(r_values, bytes.data() + at, size);
		at += size;
	}

	template <typename T>
	void take(std::vector<T> &r_values, std::size_t p_count) {
		if (p_count * sizeof(T) > bytes.size() - at) {
			is_short = true;
			return;
		}
		r_values.resize(p_count);
		take(r_values.data(), p_count);
	}

	bool is_good() const { return !is_short && at == bytes.size(); }

private:
	const std::vector<char> &bytes;
	std::size_t at = 0;
	bool is_short = false;
};

} // namespace

std::string Recording::read(const std::string &p_path) {
	constexpr float VERSION = 2.0f;
	constexpr float MAX = 1e6f;
	std::ifstream file(p_path, std::ios::binary);
	if (!file) {
		return p_path + " cannot be read";
	}
	const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
	Reader reader(bytes);
	float header[5] = {};
	reader.take(header, 5);
	const bool is_sane = header[1] >= 1.0f && header[2] >= 1.0f && header[3] >= 1.0f && header[1] <= MAX &&
			header[2] <= MAX && header[3] <= MAX && header[4] >= 1.0f;
	if (header[0] != VERSION || !is_sane) {
		return p_path + " is no recording of this version";
	}
	people = std::size_t(header[1]);
	limbs = std::size_t(header[2]);
	ticks = std::size_t(header[3]);
	hz = header[4];
	reader.take(&settings, 1);
	reader.take(bodies, people * limbs);
	reader.take(joints, people * limbs);
	reader.take(targets, ticks * tick_size());
	reader.take(ends, people * limbs);
	return reader.is_good() ? "" : p_path + " is too short or too long";
}
