// SPDX-License-Identifier: MIT
#include "cable/serial_line.hpp"

#include <algorithm>

namespace emulator {

bool SerialDevice::take(Usec p_now, Chunk &r_chunk) {
	if (_output.empty() || _output.front().time > p_now) {
		return false;
	}
	r_chunk = std::move(_output.front());
	_output.pop_front();
	return true;
}

std::size_t SerialDevice::waiting() const {
	std::size_t total = 0;
	for (const Chunk &chunk : _output) {
		total += chunk.bytes.size();
	}
	return total;
}

void SerialDevice::send(Chunk p_chunk) {
	if (!_output.empty()) {
		p_chunk.time = std::max(p_chunk.time, _output.back().time);
	}
	_output.push_back(std::move(p_chunk));
}

void SerialLine::_push(uint8_t p_value, int64_t p_nsec) {
	if (faults.drop > 0.0 && _random.uniform() < faults.drop) {
		return;
	}
	uint8_t value = p_value;
	if (faults.corrupt > 0.0 && _random.uniform() < faults.corrupt) {
		value = uint8_t(value ^ (1U + _random.next() % 255U));
	}
	_bytes.push_back({ value, 0, p_nsec });
}

void SerialLine::pull(SerialDevice &p_device, Usec p_now, int64_t p_byte_nsec, bool p_garbage) {
	SerialDevice::Chunk chunk;
	while (_free_nsec <= p_now * 1000 && p_device.take(p_now, chunk)) {
		int64_t nsec = std::max(chunk.time * 1000, _free_nsec);
		for (const uint8_t byte : chunk.bytes) {
			nsec += p_byte_nsec;
			_push(p_garbage ? uint8_t(_random.next()) : byte, nsec);
		}
		_free_nsec = nsec;
		if (chunk.counter >= 0 && !_bytes.empty()) {
			_bytes.back().ends++;
			_traces.push_back({ chunk.counter, chunk.time, nsec / 1000, 0 });
		}
	}
}

void SerialLine::advance(SerialDevice &p_device, Usec p_now, int64_t p_byte_nsec, bool p_garbage) {
	for (Usec time = p_device.next_event(); time <= p_now; time = p_device.next_event()) {
		p_device.advance(time);
		pull(p_device, time, p_byte_nsec, p_garbage);
	}
	p_device.advance(p_now);
	pull(p_device, p_now, p_byte_nsec, p_garbage);
}

Usec SerialLine::next_pull(const SerialDevice &p_device) const {
	const Usec ready = p_device.next_output();
	return ready == NEVER ? NEVER : std::max(ready, (_free_nsec + 999) / 1000);
}

Usec SerialLine::arrival(std::size_t p_number) const {
	return p_number > _bytes.size() ? NEVER : (_bytes[p_number - 1].nsec + 999) / 1000;
}

std::size_t SerialLine::arrived(Usec p_now) const {
	const auto later = [](int64_t p_nsec, const Byte &p_byte) { return p_nsec < p_byte.nsec; };
	return std::size_t(std::upper_bound(_bytes.begin(), _bytes.end(), p_now * 1000, later) - _bytes.begin());
}

std::size_t SerialLine::take(uint8_t *r_bytes, std::size_t p_most, Usec p_now) {
	const std::size_t count = std::min(p_most, arrived(p_now));
	for (std::size_t i = 0; i < count; i++) {
		r_bytes[i] = _bytes[i].value;
	}
	drop(count);
	return count;
}

void SerialLine::drop(std::size_t p_count) {
	for (std::size_t i = 0; i < p_count && !_bytes.empty(); i++) {
		const auto ended = _traces.begin() + _bytes.front().ends;
		_done.insert(_done.end(), _traces.begin(), ended);
		_traces.erase(_traces.begin(), ended);
		_bytes.pop_front();
	}
}

void SerialLine::clear() {
	_bytes.clear();
	_traces.clear();
	_done.clear();
}

void SerialLine::collect(std::vector<SampleTrace> &r_traces, Usec p_handed_over) {
	for (SampleTrace &trace : _done) {
		trace.handed_over = p_handed_over;
		r_traces.push_back(trace);
	}
	_done.clear();
}

} // namespace emulator
