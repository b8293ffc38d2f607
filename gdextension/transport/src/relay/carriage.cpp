// SPDX-License-Identifier: MIT
#include "carriage.hpp"

#include <algorithm>

namespace transport {

namespace {

constexpr size_t MAX_PARTS = 7;

Bytes size_message(Carriage::Kind p_kind, size_t p_size) {
	return { p_kind, uint8_t(p_size), uint8_t(p_size >> 8) };
}

} // namespace

void Carriage::send(Content p_content, const View &p_bytes, const Send &p_send) {
	const size_t room = _mtu.limit() - _overhead;
	_mtu.note_sent(p_bytes.size + _overhead);
	if (p_bytes.size <= room) {
		p_send(p_content, p_bytes);
		return;
	}
	const size_t count = (p_bytes.size + room - PART_HEAD - 1) / (room - PART_HEAD);
	if (count > MAX_PARTS || p_bytes.size > MAX_WHOLE) {
		return;
	}
	// All of about the same size: a short last one would cost as much.
	const size_t each = (p_bytes.size + count - 1) / count;
	const uint16_t number = _next_number++;
	for (size_t i = 0; i < count; i++) {
		const size_t begin = i * each;
		_part = { PART, uint8_t(number), uint8_t(number >> 8), uint8_t(i | count << 3 | size_t(p_content) << 6) };
		append(_part, { p_bytes.data + begin, std::min(each, p_bytes.size - begin) });
		p_send(Content::FAST, _part);
	}
}

bool Carriage::take(
		Content &r_content, Bytes &r_bytes, size_t p_datagram_size, int64_t p_now_usec, const Send &p_send) {
	if (r_bytes.empty()) {
		return false;
	}
	if (r_content == Content::ENET || r_bytes[0] < FIRST_KIND || r_bytes[0] > LAST_KIND) {
		return true;
	}
	const bool has_size = r_bytes.size() >= 3;
	const size_t size = has_size ? size_t(r_bytes[1]) | size_t(r_bytes[2]) << 8 : 0;
	switch (r_bytes[0]) {
		case PART:
			return take_part(r_content, r_bytes);
		case PROBE:
			if (has_size && size == p_datagram_size) {
				p_send(Content::FAST, size_message(PROBED, size));
			}
			return false;
		case PROBED:
			_mtu.take_answer(size, p_now_usec);
			return false;
		default:
			return false;
	}
}

bool Carriage::take_part(Content &r_content, Bytes &r_bytes) {
	if (r_bytes.size() <= PART_HEAD) {
		return false;
	}
	const auto number = uint16_t(r_bytes[1] | r_bytes[2] << 8);
	const size_t index = r_bytes[3] & 7;
	const size_t count = r_bytes[3] >> 3 & 7;
	if (index >= count || r_bytes[3] >> 7 != 0 || r_bytes.size() - PART_HEAD > (MAX_WHOLE + count - 1) / count) {
		return false;
	}
	Whole &whole = whole_of(number, r_bytes[3] >> 3);
	if (!whole.parts[index].empty()) {
		return false;
	}
	whole.parts[index].assign(r_bytes.begin() + PART_HEAD, r_bytes.end());
	if (--whole.missing > 0) {
		return false;
	}
	r_content = Content(whole.content_and_count >> 3);
	r_bytes.clear();
	for (const Bytes &part : whole.parts) {
		append(r_bytes, part);
	}
	_open.erase(_open.begin() + (&whole - _open.data()));
	// What is the transport's own is never in parts.
	return r_content == Content::ENET || r_bytes[0] < FIRST_KIND || r_bytes[0] > LAST_KIND;
}

Carriage::Whole &Carriage::whole_of(uint16_t p_number, uint8_t p_content_and_count) {
	const auto found = std::find_if(_open.begin(), _open.end(), [=](const Whole &p_whole) {
		return p_whole.number == p_number && p_whole.content_and_count == p_content_and_count;
	});
	if (found != _open.end()) {
		return *found;
	}
	if (_open.size() >= MAX_OPEN) {
		_open.erase(_open.begin());
	}
	Whole made;
	made.number = p_number;
	made.content_and_count = p_content_and_count;
	made.missing = p_content_and_count & 7;
	made.parts.resize(made.missing);
	_open.push_back(std::move(made));
	return _open.back();
}

void Carriage::look_after(int64_t p_now_usec, const Send &p_send) {
	_mtu.look_after(p_now_usec, [this, &p_send](size_t p_size) {
		Bytes probe = size_message(PROBE, p_size);
		probe.resize(p_size - _overhead);
		p_send(Content::FAST, probe);
	});
}

} // namespace transport
