// SPDX-License-Identifier: MIT
#pragma once

#include "recording/format.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace recording {

/// One record; its payload lies in the file's bytes.
struct Record {
	Kind kind = Kind::END;
	int stream = 0;
	uint64_t time_usec = 0;
	const uint8_t *payload = nullptr;
	std::size_t size = 0;
};

/// What a recording is worth.
struct ReaderStats {
	uint64_t records = 0;
	uint64_t payload_bytes = 0;
	/// Records whose bytes are not those that were written.
	uint64_t damaged_records = 0;
	/// Bytes that belong to no record.
	uint64_t damaged_bytes = 0;
	/// Bytes of a record at the end that is not all there.
	uint64_t cut_bytes = 0;
	/// Records that the recorder itself had to leave out.
	uint64_t lost = 0;
	/// Whether it was ended in order.
	bool has_end = false;
};

/// Whether bytes are a recording of ours.
bool is_recording(const uint8_t *p_bytes, std::size_t p_size);

/// Gives the records of a recording one after the other. Whatever is damaged is passed over and counted; what is
/// in front of a cut and behind damage is all there.
class Reader {
public:
	/// Takes the bytes of a file. Returns what is wrong, or an empty text.
	std::string open(std::vector<uint8_t> p_bytes);
	/// The same from a file.
	std::string open_file(const std::string &p_path);

	/// The next record; false at the end.
	bool next(Record &r_record);
	/// Back to the first.
	void rewind();
	/// Of what was read so far.
	const ReaderStats &stats() const { return _stats; }

private:
	/// Where the next head is from here on; the end of the bytes if there is none.
	std::size_t find_head(std::size_t p_from) const;
	bool is_head(std::size_t p_at) const;

	std::vector<uint8_t> _bytes;
	std::size_t _at = 0;
	/// Bytes of payloads that were looked through for heads: bounded, or a made-up file could keep us for hours.
	std::size_t _searched = 0;
	ReaderStats _stats;
};

/// The value of a key in lines "key=value", or an empty text.
std::string about(const Record &p_record, const std::string &p_key);

} // namespace recording
