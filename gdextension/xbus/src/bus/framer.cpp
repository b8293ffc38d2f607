// SPDX-License-Identifier: MIT
#include "bus/framer.hpp"

namespace xbus {

void Framer::reset() {
	_begin = _end = 0;
	_in_stretch = false;
	_statistics = {};
}

void Framer::_drop_pending(std::size_t p_count) {
	const uint8_t *first = _buffer.data() + _begin;
	const void *found = pending() > p_count ? std::memchr(first + p_count, PREAMBLE, pending() - p_count) : nullptr;
	const std::size_t dropped = found == nullptr ? pending() : std::size_t(static_cast<const uint8_t *>(found) - first);
	_skip(dropped);
	_begin += dropped;
	if (_begin == _end) {
		_begin = _end = 0;
	}
}

// There is always room: what is pending is less than one message, and a message fits.
void Framer::_append(const uint8_t *p_bytes, std::size_t p_size) {
	if (p_size == 0) {
		return;
	}
	if (_end + p_size > _buffer.size()) {
		std::memmove(_buffer.data(), _buffer.data() + _begin, pending());
		_end -= _begin;
		_begin = 0;
	}
	std::memcpy(_buffer.data() + _end, p_bytes, p_size);
	_end += p_size;
}

} // namespace xbus
