// SPDX-License-Identifier: MIT
#pragma once

#include "bus/configuration.hpp"
#include "bus/counter_track.hpp"
#include "bus/mt_data2.hpp"
#include "bus/plausibility.hpp"

namespace xbus {

/// Whether a device can send this message: a known identifier, a length that goes with it, a bus identifier
/// that exists. An eight-bit checksum alone lets through too much.
bool is_device_message(const Frame &p_frame);

/// A number for the identifiers and lengths of an MTData2 message's items: the same for messages of one kind.
uint32_t message_shape(const Frame &p_frame);

/// Public stats of a stream.
struct StreamStatistics {
	/// Messages taken, with samples and without.
	uint64_t data = 0;
	uint64_t control = 0;
	/// Messages refused: none that a device sends, data of another size than configured, values that cannot be.
	uint64_t impossible = 0;
	uint64_t wrong_sizes = 0;
	uint64_t implausible = 0;
	/// Items of MTData2 that are not understood.
	uint64_t unknown_items = 0;
};

/// Decodes and judges what one master, or one tracker that stands alone, sends. Made to be a framer's sink:
/// what it refuses, the framer takes for no message at all and looks behind its first byte.
///
///     framer.feed(bytes, size, [&](const Frame &p_frame) {
///         const bool noisy = framer.statistics().is_noisy();
///         return check.take(p_frame, noisy) != StreamCheck::Verdict::REFUSED;
///     });
class StreamCheck {
public:
	enum class Verdict : uint8_t {
		REFUSED,
		/// Samples are there to be read: samples() of them.
		DATA,
		/// A message without samples: an answer, an error, data whose format is not known.
		CONTROL,
	};

	/// Forgets formats, counters and stats. Without a format MTData is CONTROL; MTData2 needs none.
	void reset();
	/// Another measurement begins: counters may begin anywhere. Formats and stats stay.
	void restart();

	/// MTData comes from a master with these trackers.
	void expect_master(const MasterFormat &p_format);
	/// MTData comes from a tracker that stands alone; its counter goes `p_counter_step` up each time.
	void expect_tracker(const OutputFormat &p_format, uint32_t p_counter_step = 1);
	/// Trackers behind the master, if they are known: no other bus identifiers are taken.
	void expect_devices(std::size_t p_count) { _device_count = p_count < MAX_DEVICES ? p_count : MAX_DEVICES; }

	/// Judges a message; on DATA its samples are decoded. On a noisy line an MTData2 message with items that
	/// are not understood is taken only when one of the same shape has come before.
	Verdict take(const Frame &p_frame, bool p_noisy = false);

	/// Of the last message that was DATA. A sample of a sick device is empty: its `present` is 0.
	std::size_t sample_count() const { return _sample_count; }
	const Sample &sample(std::size_t p_index) const { return _samples[p_index]; }

	const StreamStatistics &statistics() const { return _statistics; }
	/// Of a device by its bus identifier (MASTER: one that stands alone).
	const DeviceStatistics &device(uint8_t p_bus_id) const { return _devices[_index(p_bus_id)].statistics; }
	/// Data bytes of MTData, 0 if its format is not known.
	std::size_t data_size() const;

private:
	struct Device {
		SampleJudge judge;
		CounterTrack counter;
		DeviceStatistics statistics;
	};

	/// Shapes of MTData2 messages with items that are not understood.
	static constexpr std::size_t SHAPES = 16;

	static std::size_t _index(uint8_t p_bus_id) { return p_bus_id == MASTER || p_bus_id > MAX_DEVICES ? 0 : p_bus_id; }
	bool _is_bus_id(uint8_t p_bus_id) const;
	Verdict _take_mt_data(const Frame &p_frame);
	Verdict _take_mt_data2(const Frame &p_frame, bool p_noisy);
	Verdict _take_master();
	Verdict _take_sample(Sample &r_sample);
	/// Whether this odd message has come before: then it is no accident.
	bool _is_known_shape(const Frame &p_frame);
	Verdict _refuse(uint64_t &r_reason);

	MasterFormat _master;
	OutputFormat _tracker;
	bool _has_master = false;
	bool _has_tracker = false;
	std::size_t _device_count = 0;
	CounterTrack _master_counter;
	/// The first is whoever answers to MASTER.
	std::array<Device, MAX_DEVICES + 1> _devices{};
	std::array<Sample, MAX_DEVICES> _samples{};
	std::size_t _sample_count = 0;
	std::array<uint32_t, SHAPES> _shapes{};
	std::size_t _shape_count = 0;
	StreamStatistics _statistics;
};

} // namespace xbus
