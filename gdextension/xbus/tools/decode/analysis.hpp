// SPDX-License-Identifier: MIT
#pragma once

#include "bus/framer.hpp"
#include "bus/stream_check.hpp"
#include "device/full_sample.hpp"
#include "recording.hpp"

#include <map>
#include <memory>
#include <optional>

/// What MTData messages look like, and how that is known.
struct DataFormat {
	/// "Configuration", "SetOutputMode", "options" or "guess".
	const char *source = "";
	bool is_master = false;
	xbus::MasterFormat trackers;
	xbus::OutputFormat tracker;

	std::size_t size() const { return is_master ? trackers.size() : tracker.size(); }
};

/// What the command line says of MTData.
struct FormatOptions {
	std::optional<uint16_t> mode;
	uint32_t settings = 0;
	bool is_master = false;
	std::size_t devices = 1;
};

/// One message of a recording.
struct Entry {
	std::size_t offset = 0;
	xbus::Frame frame;
	/// Of MTData: index into Analysis::formats, -1 if nothing is known.
	int format = -1;
	/// Values that no sensor measures, on a line that is otherwise good.
	bool is_implausible = false;
};

/// Stats of one device.
struct DeviceReport {
	uint32_t device_id = 0;
	xbus::DeviceStatistics statistics;
	xbus::CounterTrack counter;
	/// Samples a second, 0 if not known.
	double rate = 0.0;

	// For the rate: samples by the clock of the device, 1/10000 s.
	uint64_t timed_samples = 0;
	uint64_t ticks = 0;
	uint32_t last_time = 0;
	bool has_time = false;
};

/// Smallest and greatest value of each number of a field.
struct Range {
	uint64_t count = 0;
	std::vector<double> least;
	std::vector<double> most;
};

/// Everything that a recording of a bus holds.
struct Analysis {
	std::vector<Entry> entries;
	xbus::FramerStatistics framing;
	/// So much of the recording is damaged that odd messages are refused.
	bool is_noisy = false;
	std::vector<DataFormat> formats;
	std::map<std::string, uint64_t> message_counts;
	std::map<int, DeviceReport> devices;
	/// By the keys of sample_fields.hpp.
	std::map<std::string, Range> ranges;
	uint64_t undecoded = 0;
	uint64_t unknown_items = 0;
	uint64_t misfit_items = 0;
	/// 1/115200 s, 0 if no message has it.
	uint16_t period = 0;
};

/// Finds and judges all messages. The entries point into the recording.
Analysis analyse(const Recording &p_recording, const FormatOptions &p_options);

/// The samples of a data message; none if it cannot be decoded.
std::vector<xbus::FullSample> decode_samples(const Analysis &p_analysis, const Entry &p_entry);
