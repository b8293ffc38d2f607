// SPDX-License-Identifier: MIT
#include "recording/reader.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace recording {

namespace {

/// A day of three suits; more is rather another file.
constexpr off_t MAX_BYTES = off_t(8) * 1024 * 1024 * 1024;

} // namespace

bool is_recording(const uint8_t *p_bytes, std::size_t p_size) {
	return p_size >= MAGIC.size() && std::equal(MAGIC.begin(), MAGIC.end(), p_bytes);
}

std::string Reader::open(std::vector<uint8_t> p_bytes) {
	_bytes = std::move(p_bytes);
	rewind();
	return is_recording(_bytes.data(), _bytes.size()) ? "" : "is no recording of Dismount's";
}

std::string Reader::open_file(const std::string &p_path) {
	struct stat status{};
	if (stat(p_path.c_str(), &status) != 0) {
		return p_path + " can't be read: " + std::strerror(errno);
	}
	if (!S_ISREG(status.st_mode) || status.st_size > MAX_BYTES) {
		return p_path + " is no file, or too large for a recording";
	}
	const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(std::fopen(p_path.c_str(), "rb"), std::fclose);
	std::vector<uint8_t> bytes(std::size_t(status.st_size));
	if (file == nullptr) {
		return p_path + " can't be read: " + std::strerror(errno);
	}
	// It may be shorter than it was a moment ago.
	bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
	const std::string fault = open(std::move(bytes));
	return fault.empty() ? fault : p_path + " " + fault;
}

void Reader::rewind() {
	_at = std::min(MAGIC.size(), _bytes.size());
	_searched = 0;
	_stats = ReaderStats();
}

bool Reader::is_head(std::size_t p_at) const {
	if (_bytes.size() - p_at < HEAD_SIZE) {
		return false;
	}
	const uint8_t *head = _bytes.data() + p_at;
	return get_little(head, 4) == MARK && get_little(head + 24, 4) == crc32(head, 24) &&
			get_little(head + 4, 4) <= MAX_PAYLOAD && head[8] < KINDS &&
			get_little(head + 10, 2) < uint64_t(MAX_STREAMS);
}

std::size_t Reader::find_head(std::size_t p_from) const {
	while (p_from < _bytes.size()) {
		const void *found = std::memchr(_bytes.data() + p_from, int(MARK & 0xFFU), _bytes.size() - p_from);
		if (found == nullptr) {
			break;
		}
		p_from = std::size_t(static_cast<const uint8_t *>(found) - _bytes.data());
		if (is_head(p_from)) {
			return p_from;
		}
		++p_from;
	}
	return _bytes.size();
}

bool Reader::next(Record &r_record) {
	while (_at < _bytes.size()) {
		if (!is_head(_at)) {
			const std::size_t found = find_head(_at + 1);
			const bool is_cut = found == _bytes.size() && found - _at < HEAD_SIZE;
			(is_cut ? _stats.cut_bytes : _stats.damaged_bytes) += found - _at;
			_at = found;
			continue;
		}
		const uint8_t *head = _bytes.data() + _at;
		const std::size_t size = std::size_t(get_little(head + 4, 4));
		if (_bytes.size() - _at - HEAD_SIZE < size) {
			_stats.cut_bytes += _bytes.size() - _at;
			_at = _bytes.size();
			break;
		}
		if (get_little(head + 20, 4) != crc32(head + HEAD_SIZE, size)) {
			// The head is right, so the next one is where it says; unless bytes are missing in between.
			++_stats.damaged_records;
			const std::size_t behind = _at + HEAD_SIZE + size;
			const bool fits = behind == _bytes.size() || is_head(behind) || _searched > 4 * _bytes.size();
			_searched += fits ? 0 : size;
			const std::size_t found = fits ? behind : find_head(_at + 1);
			_stats.damaged_bytes += found - _at;
			_at = found;
			continue;
		}
		_at += HEAD_SIZE + size;
		r_record.kind = Kind(head[8]);
		r_record.stream = int(get_little(head + 10, 2));
		r_record.time_usec = get_little(head + 12, 8);
		r_record.payload = head + HEAD_SIZE;
		r_record.size = size;
		++_stats.records;
		_stats.payload_bytes += size;
		_stats.has_end = r_record.kind == Kind::END;
		if (r_record.kind == Kind::LOST && size == 8) {
			_stats.lost += get_little(r_record.payload, 8);
		}
		return true;
	}
	return false;
}

std::string about(const Record &p_record, const std::string &p_key) {
	const std::string text(reinterpret_cast<const char *>(p_record.payload), p_record.size);
	std::size_t at = 0;
	while (at < text.size()) {
		const std::size_t end = std::min(text.find('\n', at), text.size());
		if (text.compare(at, p_key.size() + 1, p_key + "=") == 0) {
			at += p_key.size() + 1;
			return text.substr(at, end - at);
		}
		at = end + 1;
	}
	return "";
}

} // namespace recording
