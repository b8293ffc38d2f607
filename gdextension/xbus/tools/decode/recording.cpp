// SPDX-License-Identifier: MIT
#include "recording.hpp"

#include "status_bytes.hpp"

#include "recording/bus_replay.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <sys/stat.h>

namespace {

bool read_all(const std::string &p_name, std::vector<uint8_t> &r_bytes, std::string &r_fault) {
	struct stat about = {};
	if (stat(p_name.c_str(), &about) == 0 && S_ISDIR(about.st_mode)) {
		r_fault = p_name + " is a folder.";
		return false;
	}
	const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(std::fopen(p_name.c_str(), "rb"), std::fclose);
	if (!file) {
		r_fault = p_name + " cannot be read: " + std::strerror(errno) + ".";
		return false;
	}
	std::array<uint8_t, 65536> block;
	std::size_t got = 0;
	while ((got = std::fread(block.data(), 1, block.size(), file.get())) > 0) {
		r_bytes.insert(r_bytes.end(), block.begin(), block.begin() + std::ptrdiff_t(got));
	}
	if (std::ferror(file.get()) != 0) {
		r_fault = p_name + " cannot be read to its end: " + std::strerror(errno) + ".";
		return false;
	}
	return true;
}

int hex_value(uint8_t p_digit) {
	if (std::isdigit(p_digit) != 0) {
		return p_digit - '0';
	}
	return std::isxdigit(p_digit) != 0 ? std::tolower(p_digit) - 'a' + 10 : -1;
}

/// Whether the bytes are text of nothing but pairs of hexadecimal digits: no bus sends only those.
bool read_hex(const std::vector<uint8_t> &p_text, std::vector<uint8_t> &r_bytes) {
	r_bytes.reserve(p_text.size() / 2);
	for (std::size_t i = 0; i < p_text.size();) {
		if (std::isspace(p_text[i]) != 0) {
			i++;
			continue;
		}
		const int high = hex_value(p_text[i]);
		const int low = i + 1 < p_text.size() ? hex_value(p_text[i + 1]) : -1;
		if (high < 0 || low < 0) {
			return false;
		}
		r_bytes.push_back(uint8_t(high * 16 + low));
		i += 2;
	}
	return !r_bytes.empty();
}

} // namespace

bool read_recording(const std::string &p_name, Recording &r_recording, std::string &r_fault) {
	r_recording = {};
	r_recording.name = p_name;
	if (!read_all(p_name, r_recording.bytes, r_fault)) {
		return false;
	}
	if (r_recording.bytes.empty()) {
		r_fault = p_name + " is empty.";
		return false;
	}
	if (recording::is_recording(r_recording.bytes.data(), r_recording.bytes.size())) {
		recording::Reader reader;
		reader.open(std::move(r_recording.bytes));
		r_recording.bytes = recording::bus_bytes(reader, -1, true);
		r_recording.kind = "recording";
		if (r_recording.bytes.empty()) {
			r_fault = p_name + " holds no bytes of a bus (datagrams of MVN only, or nothing).";
		}
		return r_fault.empty();
	}
	std::vector<uint8_t> bytes;
	if (read_hex(r_recording.bytes, bytes)) {
		r_recording.bytes = std::move(bytes);
		r_recording.kind = "hex";
	}
	if (strip_status_bytes(r_recording.bytes)) {
		r_recording.kind = "ftdi";
	}
	return true;
}
