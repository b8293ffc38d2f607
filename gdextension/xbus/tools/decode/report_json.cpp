// SPDX-License-Identifier: MIT
#include "report.hpp"

#include "control_json.hpp"
#include "sample_json.hpp"

#include "bus/bytes.hpp"
#include "device/items.hpp"

using namespace xbus;

namespace {

void write_framing(const FramerStatistics &p_framing, JsonWriter &r_json) {
	r_json.key("framing");
	r_json.begin_object();
	r_json.member("stretches", p_framing.stretches);
	r_json.member("bad_checksums", p_framing.bad_checksums);
	r_json.member("refused_lengths", p_framing.refused_lengths);
	r_json.member("refused_starts", p_framing.refused_starts);
	r_json.member("refused_messages", p_framing.refused_frames);
	r_json.member("incomplete_messages", p_framing.given_up);
	r_json.end_object();
}

void write_formats(const std::vector<DataFormat> &p_formats, JsonWriter &r_json) {
	r_json.key("formats");
	r_json.begin_list();
	for (const DataFormat &format : p_formats) {
		r_json.begin_object();
		r_json.member("source", format.source);
		r_json.member("master", format.is_master);
		r_json.member("data_length", uint64_t(format.size()));
		r_json.key("trackers");
		r_json.begin_list();
		for (std::size_t i = 0; i < (format.is_master ? format.trackers.count() : 1); i++) {
			const OutputFormat &tracker = format.is_master ? format.trackers.format(i) : format.tracker;
			r_json.begin_object();
			r_json.member("mode", unsigned(tracker.mode));
			r_json.member("settings", unsigned(tracker.settings));
			r_json.end_object();
		}
		r_json.end_list();
		r_json.end_object();
	}
	r_json.end_list();
}

void write_devices(const Analysis &p_analysis, JsonWriter &r_json) {
	r_json.key("devices");
	r_json.begin_list();
	for (const auto &[bus_id, device] : p_analysis.devices) {
		r_json.begin_object();
		r_json.member("bus_id", bus_id);
		r_json.key("device_id");
		if (device.device_id != 0) {
			r_json.value(hex_id(device.device_id));
		} else {
			r_json.null();
		}
		r_json.member("kind", device_kind_name(device_kind(device.device_id)));
		r_json.member("received", device.statistics.received);
		r_json.member("lost", device.statistics.lost);
		r_json.member("duplicates", device.statistics.duplicates);
		r_json.member("late", device.statistics.late);
		r_json.member("implausible", device.statistics.implausible);
		r_json.member("resets", device.statistics.resets);
		r_json.key("rate_hz");
		if (device.rate > 0.0) {
			r_json.value(device.rate);
		} else {
			r_json.null();
		}
		r_json.end_object();
	}
	r_json.end_list();
}

void write_ranges(const std::map<std::string, Range> &p_ranges, JsonWriter &r_json) {
	r_json.key("items");
	r_json.begin_object();
	for (const auto &[key, range] : p_ranges) {
		r_json.key(key);
		r_json.begin_object();
		r_json.member("count", range.count);
		if (!range.least.empty()) {
			SampleJson values(r_json);
			values.numbers("min", range.least.data(), range.least.size());
			values.numbers("max", range.most.data(), range.most.size());
		}
		r_json.end_object();
	}
	r_json.end_object();
}

void write_item_value(const ItemType &p_type, const FullSample &p_sample, JsonWriter &r_json) {
	r_json.key("value");
	// Of all types only this one is several things at once.
	const bool several = p_type.kind == ItemKind::RAW;
	SampleJson value(r_json, !several);
	if (several) {
		r_json.begin_object();
	}
	visit_sample(p_sample, value);
	if (several) {
		r_json.end_object();
	}
}

/// The items of MTData2 in their order, those that are not understood included.
void write_items(const Frame &p_frame, JsonWriter &r_json) {
	r_json.key("items");
	r_json.begin_list();
	visit_items(p_frame.data, p_frame.size, [&](const Item &p_item) {
		const ItemType &type = item_type(p_item.id);
		FullSample sample;
		r_json.begin_object();
		r_json.member("id", hex_id(p_item.id, 4));
		r_json.key("name");
		if (type.is_known()) {
			r_json.value(type.name);
		} else {
			r_json.null();
		}
		if (type.kind == ItemKind::REALS) {
			r_json.member("format", number_format_name(p_item.format()));
		}
		if (type.has_axes()) {
			r_json.member("axes", axes_name(p_item.axes()));
		}
		if (decode_item(p_item, sample) == ItemFate::DECODED && type.kind != ItemKind::OPAQUE) {
			write_item_value(type, sample, r_json);
		} else {
			r_json.member("data", hex_data(p_item.data, p_item.size));
		}
		r_json.end_object();
	});
	r_json.end_list();
}

void write_samples(const Analysis &p_analysis, const Entry &p_entry, JsonWriter &r_json) {
	const std::vector<FullSample> samples = decode_samples(p_analysis, p_entry);
	if (samples.empty()) {
		r_json.member("data", hex_data(p_entry.frame.data, p_entry.frame.size));
		return;
	}
	r_json.key("samples");
	r_json.begin_list();
	for (const FullSample &sample : samples) {
		r_json.begin_object();
		r_json.member("bus_id", unsigned(sample.bus_id));
		const bool turned = sample.has(Field::QUATERNION) || sample.has(Field::MATRIX) || sample.has(Field::EULER) ||
				sample.has(Further::VELOCITY);
		if (turned) {
			r_json.member("axes", axes_name(sample.axes));
		}
		SampleJson values(r_json);
		visit_sample(sample, values);
		r_json.end_object();
	}
	r_json.end_list();
}

void write_message(const Analysis &p_analysis, const Entry &p_entry, JsonWriter &r_json) {
	const Frame &frame = p_entry.frame;
	r_json.new_line();
	r_json.begin_object();
	r_json.member("offset", uint64_t(p_entry.offset));
	r_json.member("bus_id", unsigned(frame.bus_id));
	r_json.member("mid", unsigned(frame.message));
	r_json.key("name");
	const char *name = message_name(frame.message);
	if (name != nullptr) {
		r_json.value(name);
	} else {
		r_json.null();
	}
	r_json.member("size", uint64_t(frame.size));
	if (p_entry.is_implausible) {
		r_json.member("implausible", true);
	}
	if (frame.message == Message::MT_DATA || frame.message == Message::MT_DATA2) {
		if (p_entry.format >= 0) {
			r_json.member("format", p_entry.format);
		}
		write_samples(p_analysis, p_entry, r_json);
		if (frame.message == Message::MT_DATA2) {
			write_items(frame, r_json);
		}
	} else {
		write_control(frame, r_json);
	}
	r_json.end_object();
}

} // namespace

void write_json_report(const Recording &p_recording, const Analysis &p_analysis, std::FILE *p_file) {
	JsonWriter json(p_file);
	json.begin_object();
	json.member("file", p_recording.name);
	json.member("kind", p_recording.kind);
	json.member("bytes", p_analysis.framing.bytes);
	json.member("frames", p_analysis.framing.frames);
	json.member("malformed_bytes", p_analysis.framing.skipped_bytes);
	json.member("noisy", p_analysis.is_noisy);
	write_framing(p_analysis.framing, json);
	json.key("message_counts");
	json.begin_object();
	for (const auto &[name, count] : p_analysis.message_counts) {
		json.member(name, count);
	}
	json.end_object();
	json.member("undecoded_messages", p_analysis.undecoded);
	json.member("unknown_items", p_analysis.unknown_items);
	json.member("misfit_items", p_analysis.misfit_items);
	write_formats(p_analysis.formats, json);
	write_devices(p_analysis, json);
	write_ranges(p_analysis.ranges, json);
	json.key("messages");
	json.begin_list();
	for (const Entry &entry : p_analysis.entries) {
		write_message(p_analysis, entry, json);
	}
	json.end_list();
	json.end_object();
	json.new_line();
}
