// SPDX-License-Identifier: MIT
#pragma once

#include "bus/framer.hpp"
#include "bus/stream_check.hpp"
#include "recording/reader.hpp"
#include "session/suit_frame.hpp"
#include "session/suit_stream.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace recording {

/// Decodes what a recorded bus carried, in the same way as a session: the formats follow from what the host asked
/// for and the device answered.
class BusReplay {
public:
	BusReplay();

	/// Bytes to the device.
	void take_out(const uint8_t *p_bytes, std::size_t p_size);
	/// Bytes from the device at a time, µs. Calls `p_sink(const xbus::SuitFrame &)` for each sample.
	template <class Sink>
	void take_in(const uint8_t *p_bytes, std::size_t p_size, uint64_t p_time_usec, Sink &&p_sink) {
		const auto take = [&](const xbus::Frame &p_frame) {
			const xbus::StreamCheck::Verdict verdict = take_frame(p_frame);
			if (verdict == xbus::StreamCheck::Verdict::DATA) {
				_stream.take(_check, p_time_usec, _frame);
				p_sink(_frame);
			}
			return verdict != xbus::StreamCheck::Verdict::REFUSED;
		};
		// As a session does: a message whose rest does not come hides what comes behind it.
		if (_framer.pending() > 0 && p_time_usec > _bytes_usec + PATIENCE_USEC) {
			_framer.give_up(take);
		}
		_bytes_usec = p_time_usec;
		_framer.feed(p_bytes, p_size, take);
	}

	uint32_t device_id() const { return _device_id; }
	const std::vector<uint32_t> &tracker_ids() const { return _tracker_ids; }
	bool is_master() const;
	/// Samples per second that were asked for, 0 if that is not known.
	double rate_hz() const;
	/// Messages of samples of unknown format.
	uint64_t undecoded() const { return _undecoded; }
	const xbus::FramerStatistics &framer() const { return _framer.statistics(); }
	const xbus::DeviceStatistics &tracker(int p_tracker) const;
	xbus::TrackerFlow flow(int p_tracker, uint64_t p_now_usec) const { return _stream.flow(p_tracker, p_now_usec); }

private:
	static constexpr uint64_t PATIENCE_USEC = 50000;

	xbus::StreamCheck::Verdict take_frame(const xbus::Frame &p_frame);
	void note_request(const xbus::Frame &p_frame);
	void note_answer(const xbus::Frame &p_frame);
	void note_configuration(const xbus::Frame &p_frame);
	void expect();

	xbus::Framer _out;
	xbus::Framer _framer;
	xbus::StreamCheck _check;
	xbus::SuitStream _stream;
	xbus::SuitFrame _frame;
	/// By bus identifier.
	std::array<xbus::OutputFormat, 256> _formats{};
	std::vector<uint32_t> _tracker_ids;
	uint32_t _device_id = 0;
	uint16_t _period = 0;
	uint64_t _undecoded = 0;
	uint64_t _bytes_usec = 0;
	bool _is_stale = true;
};

/// The bytes of one bus in one piece, requests put between the answers where no message is cut: for tools that
/// read raw bytes. `p_stream` < 0: of the stream that has the most.
std::vector<uint8_t> bus_bytes(Reader &r_reader, int p_stream, bool p_with_requests);

} // namespace recording
