// SPDX-License-Identifier: MIT
#include "analysis.hpp"

#include "formats.hpp"
#include "sample_fields.hpp"

#include "bus/bytes.hpp"
#include "device/full_judge.hpp"
#include "device/items.hpp"

#include <algorithm>
#include <set>

using namespace xbus;

namespace {

constexpr double TICKS_PER_SECOND = 115200.0;

/// Feeds everything in one piece, so that messages stay where they are. What is incomplete at the end is given
/// up, and what lies behind its beginning looked at.
template <class S>
FramerStatistics frame_all(const std::vector<uint8_t> &p_bytes, S &&p_sink) {
	const auto framer = std::make_unique<Framer>();
	const auto sink = [&](const Frame &p_frame) { return p_sink(p_frame, framer->statistics()); };
	framer->feed(p_bytes.data(), p_bytes.size(), sink);
	FramerStatistics all = framer->statistics();
	std::size_t left = framer->pending();
	while (left > 0) {
		framer->reset();
		framer->feed(p_bytes.data() + p_bytes.size() - left + 1, left - 1, sink);
		const FramerStatistics &more = framer->statistics();
		all.given_up++;
		all.frames += more.frames;
		all.frame_bytes += more.frame_bytes;
		all.bad_checksums += more.bad_checksums;
		all.refused_lengths += more.refused_lengths;
		all.refused_starts += more.refused_starts;
		all.refused_frames += more.refused_frames;
		left = framer->pending();
	}
	all.stretches += all.given_up > 0 ? 1U : 0U;
	all.skipped_bytes = all.bytes - all.frame_bytes;
	return all;
}

/// What the first look at a recording finds: nothing is refused in it.
struct FirstLook {
	FramerStatistics framing;
	/// How often MTData2 messages of each shape come.
	std::map<uint32_t, int> shapes;
	/// MTData by size.
	std::map<std::size_t, std::vector<Frame>> data;

	int count_of(uint32_t p_shape) const {
		const auto found = shapes.find(p_shape);
		return found == shapes.end() ? 0 : found->second;
	}
	const std::vector<Frame> &data_of(std::size_t p_size) const {
		static const std::vector<Frame> none;
		const auto found = data.find(p_size);
		return found == data.end() ? none : found->second;
	}
};

FirstLook look(const std::vector<uint8_t> &p_bytes) {
	FirstLook found;
	found.framing = frame_all(p_bytes, [&](const Frame &p_frame, const FramerStatistics &) {
		if (p_frame.message == Message::MT_DATA2) {
			found.shapes[message_shape(p_frame)]++;
		} else if (p_frame.message == Message::MT_DATA) {
			found.data[p_frame.size].push_back(p_frame);
		}
		return true;
	});
	return found;
}

/// A second look: refuses what a damaged line made up.
class Judge {
public:
	Judge(const FirstLook &p_look, const FormatOptions &p_options) :
			_look(p_look), _book(p_options), _is_noisy(p_look.framing.is_noisy()) {}

	bool take(const Frame &p_frame, std::size_t p_offset) {
		Entry entry;
		entry.offset = p_offset;
		entry.frame = p_frame;
		if (p_frame.message == Message::MT_DATA) {
			entry.format = _format(p_frame.size);
		}
		const bool sensible = _is_sensible(entry);
		if (_is_noisy && !sensible) {
			return false;
		}
		entry.is_implausible = !sensible;
		_book.note(p_frame);
		entries.push_back(entry);
		return true;
	}

	const FormatBook &book() const { return _book; }
	bool is_noisy() const { return _is_noisy; }

	std::vector<Entry> entries;

private:
	int _format(std::size_t p_size) {
		const int known = _book.pick(p_size);
		if (known >= 0 || _guessed.count(p_size) > 0) {
			return known;
		}
		_guessed.insert(p_size);
		const std::optional<DataFormat> guess = guess_format(_look.data_of(p_size), _book.trackers());
		return guess ? _book.add(*guess) : -1;
	}
	bool _is_sensible(const Entry &p_entry) {
		const Frame &frame = p_entry.frame;
		if (frame.message == Message::MT_DATA) {
			return _is_data_sensible(p_entry);
		}
		if (frame.message == Message::MT_DATA2) {
			FullSample sample;
			const bool is_clean = decode_mt_data2(frame.data, frame.size, sample).is_clean();
			const bool odd = !is_clean && _look.count_of(message_shape(frame)) < 2;
			return _check->take(frame, odd) != StreamCheck::Verdict::REFUSED && _judges[frame.bus_id].accept(sample);
		}
		if (is_device_message(frame)) {
			return true;
		}
		// From the host: short, and known.
		const bool is_request = (uint8_t(frame.message) & 1U) == 0 || frame.message == Message::WAKE_UP_ACK;
		return is_request && message_name(frame.message) != nullptr && frame.size <= MAX_SHORT_DATA &&
				(frame.bus_id == MASTER || frame.bus_id <= MAX_DEVICES);
	}
	bool _is_data_sensible(const Entry &p_entry) {
		if (p_entry.format < 0) {
			// Without a format, what comes once is rather an accident.
			return _look.data_of(p_entry.frame.size).size() > 1;
		}
		if (p_entry.format != _checked) {
			const DataFormat &format = _book.formats()[std::size_t(p_entry.format)];
			if (format.is_master) {
				_data_check->expect_master(format.trackers);
			} else {
				_data_check->expect_tracker(format.tracker);
			}
			_checked = p_entry.format;
		}
		return _data_check->take(p_entry.frame) != StreamCheck::Verdict::REFUSED && _is_rest_sensible(p_entry);
	}
	/// What is behind a master is judged for itself, tracker by tracker.
	bool _is_rest_sensible(const Entry &p_entry) {
		std::vector<FullSample> samples;
		decode_frame(_book.formats()[std::size_t(p_entry.format)], p_entry.frame, samples);
		bool is_sensible = true;
		for (const FullSample &sample : samples) {
			is_sensible = _data_judges[sample.bus_id].accept(sample) && is_sensible;
		}
		return is_sensible;
	}

	const FirstLook &_look;
	FormatBook _book;
	bool _is_noisy;
	std::set<std::size_t> _guessed;
	std::unique_ptr<StreamCheck> _check = std::make_unique<StreamCheck>();
	std::unique_ptr<StreamCheck> _data_check = std::make_unique<StreamCheck>();
	/// By bus identifier.
	std::array<FurtherJudge, 256> _judges;
	std::array<FurtherJudge, 256> _data_judges;
	int _checked = -1;
};

/// Notes ranges of values.
class RangeNotes {
public:
	explicit RangeNotes(std::map<std::string, Range> &r_ranges) : _ranges(r_ranges) {}

	void numbers(const char *p_key, const double *p_values, std::size_t p_count) {
		Range &range = _ranges[p_key];
		range.least.resize(p_count, p_values[0]);
		range.most.resize(p_count, p_values[0]);
		for (std::size_t i = 0; i < p_count; i++) {
			range.least[i] = range.count == 0 ? p_values[i] : std::min(range.least[i], p_values[i]);
			range.most[i] = range.count == 0 ? p_values[i] : std::max(range.most[i], p_values[i]);
		}
		range.count++;
	}
	void integer(const char *p_key, int64_t p_value) {
		const auto value = double(p_value);
		numbers(p_key, &value, 1);
	}
	template <class A>
	void integers(const char *p_key, const A &p_values) {
		std::vector<double> values(p_values.begin(), p_values.end());
		numbers(p_key, values.data(), values.size());
	}
	template <class T>
	void structure(const char *p_key, const T &) {
		_ranges[p_key].count++;
	}

private:
	std::map<std::string, Range> &_ranges;
};

void note_time(const FullSample &p_sample, DeviceReport &r_device) {
	if (!p_sample.has(Field::SAMPLE_TIME_FINE)) {
		return;
	}
	constexpr uint32_t SECOND = 10000;
	const uint32_t ahead = p_sample.sample_time_fine - r_device.last_time;
	const uint32_t behind = r_device.last_time - p_sample.sample_time_fine;
	// A satellite receiver's data come later than the time in them.
	if (r_device.has_time && behind <= SECOND) {
		return;
	}
	// Longer pauses are no part of the rate.
	if (r_device.has_time && ahead <= SECOND) {
		r_device.ticks += ahead;
		r_device.timed_samples++;
	}
	r_device.has_time = true;
	r_device.last_time = p_sample.sample_time_fine;
}

void note_sample(const FullSample &p_sample, Analysis &r_analysis) {
	DeviceReport &device = r_analysis.devices[p_sample.bus_id];
	if (p_sample.has(Field::COUNTER)) {
		device.counter.see(p_sample.counter, p_sample.counter_bits, device.statistics);
	} else {
		device.statistics.received++;
	}
	if (p_sample.has(Further::DEVICE_ID)) {
		device.device_id = p_sample.device_id;
	}
	note_time(p_sample, device);
	RangeNotes notes(r_analysis.ranges);
	visit_sample(p_sample, notes);
}

void note_items(const Frame &p_frame, Analysis &r_analysis) {
	FullSample sample;
	const ItemReport report = decode_mt_data2(p_frame.data, p_frame.size, sample);
	r_analysis.unknown_items += report.unknown;
	r_analysis.misfit_items += report.misfits;
}

/// Identifiers, period, steps of counters: what devices and host report of themselves.
void note_control(const Frame &p_frame, Analysis &r_analysis) {
	Configuration configuration;
	switch (p_frame.message) {
		case Message::DEVICE_ID:
			if (p_frame.size >= 4) {
				r_analysis.devices[p_frame.bus_id].device_id = read_u32(p_frame.data);
			}
			break;
		case Message::INIT_BUS_RESULTS:
			for (std::size_t i = 0; i < p_frame.size / 4; i++) {
				r_analysis.devices[int(i) + 1].device_id = read_u32(p_frame.data + i * 4);
			}
			break;
		case Message::SET_PERIOD:
		case Message::SET_PERIOD_ACK:
			r_analysis.period = p_frame.size == 2 ? read_u16(p_frame.data) : r_analysis.period;
			break;
		case Message::SET_OUTPUT_SKIP_FACTOR:
			if (p_frame.size == 2) {
				r_analysis.devices[p_frame.bus_id].counter.set_step(read_u16(p_frame.data) + 1U);
			}
			break;
		case Message::CONFIGURATION:
			if (configuration.parse(p_frame.data, p_frame.size) != ConfigurationFault::NONE) {
				break;
			}
			r_analysis.period = configuration.period;
			r_analysis.devices[MASTER].device_id = configuration.master_id;
			for (std::size_t i = 0; configuration.device_count > 1 && i < configuration.device_count; i++) {
				r_analysis.devices[int(i) + 1].device_id = configuration.devices[i].device_id;
			}
			break;
		default:
			break;
	}
}

void note_entry(const Entry &p_entry, Analysis &r_analysis) {
	const Frame &frame = p_entry.frame;
	const char *name = message_name(frame.message);
	std::array<char, 8> number;
	std::snprintf(number.data(), number.size(), "0x%02X", unsigned(frame.message));
	r_analysis.message_counts[name != nullptr ? name : number.data()]++;
	if (frame.message != Message::MT_DATA && frame.message != Message::MT_DATA2) {
		note_control(frame, r_analysis);
		return;
	}
	const std::vector<FullSample> samples = decode_samples(r_analysis, p_entry);
	r_analysis.undecoded += samples.empty() ? 1U : 0U;
	for (const FullSample &sample : samples) {
		note_sample(sample, r_analysis);
		r_analysis.devices[sample.bus_id].statistics.implausible += p_entry.is_implausible ? 1U : 0U;
	}
	if (frame.message == Message::MT_DATA2) {
		note_items(frame, r_analysis);
	}
}

} // namespace

std::vector<FullSample> decode_samples(const Analysis &p_analysis, const Entry &p_entry) {
	const Frame &frame = p_entry.frame;
	std::vector<FullSample> samples(1);
	if (frame.message == Message::MT_DATA2) {
		const ItemReport report = decode_mt_data2(frame.data, frame.size, samples[0]);
		samples[0].bus_id = frame.bus_id;
		samples.resize(report.whole ? 1 : 0);
		return samples;
	}
	if (frame.message != Message::MT_DATA || p_entry.format < 0) {
		return {};
	}
	decode_frame(p_analysis.formats[std::size_t(p_entry.format)], frame, samples);
	return samples;
}

Analysis analyse(const Recording &p_recording, const FormatOptions &p_options) {
	const std::vector<uint8_t> &bytes = p_recording.bytes;
	const FirstLook first = look(bytes);
	Judge judge(first, p_options);
	Analysis analysis;
	analysis.framing = frame_all(bytes, [&](const Frame &p_frame, const FramerStatistics &) {
		const auto data = std::size_t(p_frame.data - bytes.data());
		// The extended form's length byte lies three before the data's two length bytes.
		const bool extended = data >= 6 && bytes[data - 6] == PREAMBLE && bytes[data - 5] == p_frame.bus_id &&
				bytes[data - 4] == uint8_t(p_frame.message) && bytes[data - 3] == EXTENDED &&
				read_u16(&bytes[data - 2]) == p_frame.size;
		return judge.take(p_frame, data - (extended ? 6 : 4));
	});
	analysis.is_noisy = judge.is_noisy();
	analysis.formats = judge.book().formats();
	analysis.entries = std::move(judge.entries);
	for (const Entry &entry : analysis.entries) {
		note_entry(entry, analysis);
	}
	for (auto &[bus_id, device] : analysis.devices) {
		const double by_period = analysis.period > 0 ? TICKS_PER_SECOND / double(analysis.period) : 0.0;
		device.rate = device.ticks > 0 ? 1.0e4 * double(device.timed_samples) / double(device.ticks) : by_period;
	}
	return analysis;
}
