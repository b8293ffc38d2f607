// SPDX-License-Identifier: MIT
#pragma once

#include <test_data.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

/// Of the sanitizers' run time; not there without one.
// NOLINTNEXTLINE(bugprone-reserved-identifier): the name is theirs.
extern "C" __attribute__((weak)) void __sanitizer_set_death_callback(void (*p_callback)());

/// What fuzzers share.
namespace fuzzing {

/// Memory of just the size asked for at its end, so that a sanitizer sees what is read beyond: one block for
/// each size, as making one for each execution would be most of the work.
class ExactBlocks {
public:
	explicit ExactBlocks(std::size_t p_most) : _blocks(p_most + 1) {
		for (std::size_t i = 0; i <= p_most; i++) {
			_blocks[i] = std::make_unique<uint8_t[]>(i);
		}
	}
	uint8_t *of(std::size_t p_size) { return _blocks[p_size].get(); }

private:
	std::vector<std::unique_ptr<uint8_t[]>> _blocks;
};

/// The files of a fuzzer's corpus, by name: tests/corpus/<fuzzer> of its module. They are tried as they are, then
/// damaged like all other seeds. What a fuzzer trips over belongs there.
class Corpus {
public:
	using Bytes = std::vector<uint8_t>;

	/// A folder of gdextension/. Files above `p_most` bytes are cut.
	Corpus(const char *p_folder, std::size_t p_most) {
		std::vector<std::filesystem::path> paths;
		const std::filesystem::path sources = test_data::SOURCES;
		for (const auto &entry : std::filesystem::directory_iterator(sources / p_folder)) {
			paths.push_back(entry.path());
		}
		std::sort(paths.begin(), paths.end());
		for (const std::filesystem::path &path : paths) {
			std::ifstream file(path, std::ios::binary);
			Bytes bytes{ std::istreambuf_iterator<char>(file), {} };
			bytes.resize(std::min(bytes.size(), p_most));
			_files.push_back(bytes);
		}
	}

	const std::vector<Bytes> &files() const { return _files; }
	/// The file to be tried unchanged in an execution, or null when all were.
	const Bytes *whole(uint64_t p_execution) const {
		return p_execution < _files.size() ? &_files[std::size_t(p_execution)] : nullptr;
	}

private:
	std::vector<Bytes> _files;
};

/// Keeps an eye on the present input, and writes it to crash.bin in the working folder when an execution fails or a
/// sanitizer ends the program.
class LastInput {
public:
	static void note(const uint8_t *p_bytes, std::size_t p_size) {
		bytes() = p_bytes;
		size() = p_size;
	}
	static void keep() {
		std::ofstream("crash.bin", std::ios::binary)
				.write(reinterpret_cast<const char *>(bytes()), std::streamsize(size()));
		std::fprintf(stderr, "the input was written to crash.bin: keep it in the fuzzer's corpus\n");
	}
	/// Lets a sanitizer keep the input before it ends the program.
	static void arm() {
		if (__sanitizer_set_death_callback != nullptr) {
			__sanitizer_set_death_callback(keep);
		}
	}

private:
	static const uint8_t *&bytes() {
		static const uint8_t *value = nullptr;
		return value;
	}
	static std::size_t &size() {
		static std::size_t value = 0;
		return value;
	}
};

/// Fast numbers; their quality hardly matters.
class Random {
public:
	explicit Random(uint64_t p_seed) : _state(p_seed * 2 + 1) {}
	uint32_t operator()() {
		_state = _state * 6364136223846793005ULL + 1442695040888963407ULL;
		return uint32_t(_state >> 33U);
	}
	uint32_t below(uint32_t p_end) { return (*this)() % p_end; }

private:
	uint64_t _state;
};

} // namespace fuzzing
