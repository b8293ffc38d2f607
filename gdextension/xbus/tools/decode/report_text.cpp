// SPDX-License-Identifier: MIT
#include "report.hpp"

#include "device/items.hpp"

#include <cinttypes>
#include <cstring>

using namespace xbus;

namespace {

void write_formats(const std::vector<DataFormat> &p_formats, std::FILE *p_file) {
	for (const DataFormat &format : p_formats) {
		const OutputFormat &tracker = format.is_master ? format.trackers.format(0) : format.tracker;
		std::fprintf(p_file, "MTData as in %s: ", format.source);
		if (format.is_master) {
			std::fprintf(p_file, "a master with %zu trackers, ", format.trackers.count());
		}
		std::fprintf(p_file, "mode 0x%04X, settings 0x%08X, %s%s\n", unsigned(tracker.mode), unsigned(tracker.settings),
				number_format_name(tracker.numbers()),
				std::string(format.source) == "guess" ? " (a guess: --mode= and --settings= override it)" : "");
	}
}

void write_devices(const Analysis &p_analysis, std::FILE *p_file) {
	std::fprintf(p_file, "\n%-6s %-10s %-16s %9s %8s %7s %10s %6s %11s %6s\n", "bus id", "device id", "kind", "rate Hz",
			"received", "lost", "duplicates", "late", "implausible", "resets");
	for (const auto &[bus_id, device] : p_analysis.devices) {
		const DeviceStatistics &statistics = device.statistics;
		std::fprintf(p_file,
				"%-6d %08X   %-16s %9.2f %8" PRIu64 " %7" PRIu64 " %10" PRIu64 " %6" PRIu64 " %11" PRIu64 " %6" PRIu64
				"\n",
				bus_id, unsigned(device.device_id), device_kind_name(device_kind(device.device_id)), device.rate,
				statistics.received, statistics.lost, statistics.duplicates, statistics.late, statistics.implausible,
				statistics.resets);
	}
}

void write_ranges(const std::map<std::string, Range> &p_ranges, std::FILE *p_file) {
	std::fprintf(p_file, "\n%-26s %8s   range\n", "item", "count");
	for (const auto &[key, range] : p_ranges) {
		std::fprintf(p_file, "%-26s %8" PRIu64 "  ", key.c_str(), range.count);
		for (std::size_t i = 0; i < range.least.size(); i++) {
			std::fprintf(p_file, " %.6g..%.6g", range.least[i], range.most[i]);
		}
		std::fprintf(p_file, "\n");
	}
}

} // namespace

void write_text_report(const Recording &p_recording, const Analysis &p_analysis, std::FILE *p_file) {
	const FramerStatistics &framing = p_analysis.framing;
	std::fprintf(p_file, "%s: %" PRIu64 " bytes (%s), %" PRIu64 " messages, %" PRIu64 " malformed bytes\n",
			p_recording.name.c_str(), framing.bytes, p_recording.kind, framing.frames, framing.skipped_bytes);
	if (std::strcmp(p_recording.kind, "ftdi") == 0) {
		std::fprintf(p_file, "  a capture with the status bytes of an FTDI chip, which are left out\n");
	}
	if (framing.skipped_bytes > 0) {
		std::fprintf(p_file,
				"  in %" PRIu64 " stretches: %" PRIu64 " bad checksums, %" PRIu64 " lengths and %" PRIu64
				" messages refused, %" PRIu64 " incomplete\n",
				framing.stretches, framing.bad_checksums, framing.refused_lengths, framing.refused_frames,
				framing.given_up);
	}
	for (const auto &[name, count] : p_analysis.message_counts) {
		std::fprintf(p_file, "  %-26s %8" PRIu64 "\n", name.c_str(), count);
	}
	write_formats(p_analysis.formats, p_file);
	if (p_analysis.undecoded > 0) {
		std::fprintf(p_file,
				"%" PRIu64 " data messages could not be decoded: give their format by --mode= and --settings=\n",
				p_analysis.undecoded);
	}
	if (p_analysis.unknown_items + p_analysis.misfit_items > 0) {
		std::fprintf(p_file, "%" PRIu64 " items of unknown types, %" PRIu64 " with lengths that they cannot have\n",
				p_analysis.unknown_items, p_analysis.misfit_items);
	}
	if (!p_analysis.devices.empty()) {
		write_devices(p_analysis, p_file);
	}
	if (!p_analysis.ranges.empty()) {
		write_ranges(p_analysis.ranges, p_file);
	}
}
