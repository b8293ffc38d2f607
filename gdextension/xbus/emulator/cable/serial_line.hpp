// SPDX-License-Identifier: MIT
#pragma once

#include "cable/random.hpp"
#include "cable/time.hpp"

#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace emulator {

/// What hangs on a serial line (or on the bulk endpoints of a chip of its own): a master, a tracker.
class SerialDevice {
public:
	virtual ~SerialDevice() = default;

	/// Power comes, or goes.
	virtual void power(bool p_on, Usec p_now) = 0;
	/// Bytes from the host have arrived whole.
	virtual void receive(const uint8_t *p_bytes, std::size_t p_size, Usec p_now) = 0;
	/// Does what was due until `p_now`.
	virtual void advance(Usec p_now) = 0;
	/// When something is due next.
	virtual Usec next_event() const = 0;
	/// Bits a second that the device sends and understands.
	virtual uint32_t baud() const = 0;

	/// Bytes for the host that wait for the line, and when they were ready.
	struct Chunk {
		Usec time = 0;
		std::vector<uint8_t> bytes;
		/// Sample counter, where this ends a sample's message; -1 elsewhere.
		int counter = -1;
	};
	/// The next bytes that were ready by `p_now`; false if there are none.
	bool take(Usec p_now, Chunk &r_chunk);

	/// When the next bytes are ready.
	Usec next_output() const { return _output.empty() ? NEVER : _output.front().time; }

protected:
	/// Sends bytes, after what was sent before.
	void send(Chunk p_chunk);
	/// What the device has still to send, bytes.
	std::size_t waiting() const;
	void forget() { _output.clear(); }
	/// What was sent last ends the message of a sample.
	void mark_last(int p_counter) { _output.back().counter = p_counter; }
	/// Cuts what was sent last in the middle.
	void halve_last() { _output.back().bytes.resize((_output.back().bytes.size() + 1) / 2); }

private:
	std::deque<Chunk> _output;
};

/// Faults of the line from the device to the host.
struct LineFaults {
	/// Probability that a byte is changed, and that it is lost.
	double corrupt = 0.0;
	double drop = 0.0;
};

/// Samples in transit: when a sample was taken, when its last byte had passed the line, and when the host
/// got the packet with it. What a benchmark needs.
struct SampleTrace {
	int counter = 0;
	Usec sampled = 0;
	Usec on_chip = 0;
	Usec handed_over = 0;
};

/// Bytes from the device to the host, each with the time at which it is there.
class SerialLine {
public:
	explicit SerialLine(uint64_t p_seed) : _random(p_seed) {}

	/// Takes what the device has sent until `p_now`. `p_byte_nsec`: how long a byte takes on the line, 0 for
	/// a line that takes no time. `p_garbage`: both ends do not agree on the speed.
	void pull(SerialDevice &p_device, Usec p_now, int64_t p_byte_nsec, bool p_garbage);
	/// Lets the device do what is due until `p_now`, in steps: a late look must not fill its buffers, when the
	/// line would have emptied them meanwhile.
	void advance(SerialDevice &p_device, Usec p_now, int64_t p_byte_nsec, bool p_garbage);
	/// When the line is free for more, where the device has more.
	Usec next_pull(const SerialDevice &p_device) const;
	/// When the n-th byte from now (from 1) will be there; NEVER if it has not been sent.
	Usec arrival(std::size_t p_number) const;
	/// Bytes that are there at `p_now`.
	std::size_t arrived(Usec p_now) const;
	/// Takes the next bytes out, at most what has arrived.
	std::size_t take(uint8_t *r_bytes, std::size_t p_most, Usec p_now);
	/// Drops the next bytes.
	void drop(std::size_t p_count);
	void clear();
	/// Samples whose last byte was taken out since the last call.
	void collect(std::vector<SampleTrace> &r_traces, Usec p_handed_over);

	LineFaults faults;

private:
	struct Byte {
		uint8_t value = 0;
		/// How many samples' messages end here: more than one where bytes are lost.
		uint8_t ends = 0;
		int64_t nsec = 0;
	};
	void _push(uint8_t p_value, int64_t p_nsec);

	std::deque<Byte> _bytes;
	std::deque<SampleTrace> _traces;
	std::vector<SampleTrace> _done;
	int64_t _free_nsec = 0;
	Random _random;
};

} // namespace emulator
