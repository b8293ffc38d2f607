// SPDX-License-Identifier: MIT
// Streams from all suits on this machine without an engine, and says what came: for benchmarks, for tests with
// the kernel's own drivers, and for a look at a new device.
//
//     suit_stream [--seconds=N] [--rate=HZ] [--trace=FILE] [--frames=N] [--record=FILE]
//
// It ends after so many seconds, or as soon as every tracker has been received so many times (--frames). The
// trace has a line for each frame: device, sample counter of the device, when the frame was handed over (µs
// of CLOCK_MONOTONIC), trackers. The recording has all raw bytes (docs/recordings.md). The last line of the
// output is a JSON object with the stats.
#include "clock/clock.hpp"
#include "recording/taps.hpp"
#include "usb/libusb_hub.hpp"

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>

namespace {

volatile std::sig_atomic_t stops = 0;

void on_signal(int /*p_signal*/) {
	stops = 1;
}

struct FileCloser {
	void operator()(std::FILE *p_file) const { std::fclose(p_file); }
};
using File = std::unique_ptr<std::FILE, FileCloser>;

/// Notes frames in the hub's own thread: what a callback of the program would see.
class Tracer final : public usb::HubListener {
public:
	explicit Tracer(File p_file) : _file(std::move(p_file)) {}

	void take_frame(int p_device, const xbus::SuitFrame &p_frame) override {
		++frames;
		if (_file != nullptr) {
			std::fprintf(_file.get(), "%d %llu %llu %d\n", p_device, (unsigned long long)p_frame.counter,
					(unsigned long long)clocks::now_usec(), p_frame.tracker_count);
		}
	}
	void take_raw(
			int p_device, bool p_is_out, const uint8_t *p_bytes, std::size_t p_size, uint64_t p_time_usec) override {
		tap.take_raw(p_device, p_is_out, p_bytes, p_size, p_time_usec);
	}
	void device_opened(const usb::DeviceReport &p_report) override { tap.device_opened(p_report); }

	recording::BusTap tap;
	std::atomic<uint64_t> frames{ 0 };

private:
	File _file;
};

struct Arguments {
	double seconds = 0.0;
	uint64_t frames = 0;
	std::string trace;
	std::string record;
	xbus::SessionOptions session;
};

bool parse(int p_count, char **p_values, Arguments &r_arguments) {
	for (int at = 1; at < p_count; ++at) {
		const std::string argument = p_values[at];
		const std::size_t sign = argument.find('=');
		const std::string name = argument.substr(0, sign);
		const std::string value = sign == std::string::npos ? "" : argument.substr(sign + 1);
		if (name == "--seconds") {
			r_arguments.seconds = std::strtod(value.c_str(), nullptr);
		} else if (name == "--rate") {
			r_arguments.session.rate_hz = std::strtod(value.c_str(), nullptr);
		} else if (name == "--frames") {
			r_arguments.frames = std::strtoull(value.c_str(), nullptr, 10);
		} else if (name == "--trace") {
			r_arguments.trace = value;
		} else if (name == "--record") {
			r_arguments.record = value;
		} else {
			std::fprintf(stderr, "suit_stream [--seconds=N] [--rate=HZ] [--trace=FILE] [--frames=N] [--record=FILE]\n");
			return false;
		}
	}
	return true;
}

void print_messages(usb::Hub &p_hub) {
	constexpr const char *NAMES[] = { "info", "warning", "error" };
	for (const usb::HubMessage &message : p_hub.take_messages()) {
		std::printf("%s: %s\n", NAMES[int(message.severity)], message.text.c_str());
	}
	std::fflush(stdout);
}

void print_trackers(const xbus::SessionReport &p_session) {
	std::printf("\"trackers\":[");
	for (std::size_t at = 0; at < p_session.trackers.size(); ++at) {
		const xbus::TrackerReport &tracker = p_session.trackers[at];
		std::printf("%s{\"id\":\"%08X\",\"received\":%llu,\"lost\":%llu,\"rate_hz\":%.2f}", at > 0 ? "," : "",
				tracker.device_id, (unsigned long long)tracker.samples.received,
				(unsigned long long)tracker.samples.lost, tracker.flow.rate_hz);
	}
	std::printf("]");
}

void print_report(const std::vector<usb::DeviceReport> &p_reports, uint64_t p_frames) {
	std::printf("{\"frames\":%llu,\"devices\":[", (unsigned long long)p_frames);
	for (std::size_t at = 0; at < p_reports.size(); ++at) {
		const usb::DeviceReport &report = p_reports[at];
		std::printf(
				"%s{\"address\":\"%s\",\"usb\":\"%04x:%04x\",\"serial\":\"%s\",\"state\":\"%s\",\"device_id\":\"%08X\","
				"\"baud\":%u,\"rate_hz\":%.1f,\"battery\":%.2f,\"malformed_bytes\":%llu,\"errors\":%llu,"
				"\"restarts\":%llu,\"line_faults\":%llu,",
				at > 0 ? "," : "", report.address.c_str(), report.known.vendor, report.known.product,
				report.serial.c_str(), xbus::state_text(report.session.state), report.session.device_id,
				report.session.baud, report.session.rate_hz, report.session.battery,
				(unsigned long long)report.session.framer.skipped_bytes, (unsigned long long)report.session.errors,
				(unsigned long long)report.session.restarts, (unsigned long long)report.port.ftdi.line_faults);
		print_trackers(report.session);
		std::printf("}");
	}
	std::printf("]}\n");
}

/// Whether every tracker of every device has been received so often.
bool has_enough(const std::vector<usb::DeviceReport> &p_reports, uint64_t p_frames) {
	bool is_any = false;
	for (const usb::DeviceReport &report : p_reports) {
		for (const xbus::TrackerReport &tracker : report.session.trackers) {
			if (tracker.samples.received < p_frames) {
				return false;
			}
			is_any = true;
		}
		if (report.session.trackers.empty() && report.fault.empty()) {
			return false; // It is still being set up.
		}
	}
	return is_any && p_frames > 0;
}

} // namespace

int main(int p_count, char **p_values) {
	Arguments arguments;
	if (!parse(p_count, p_values, arguments)) {
		return 2;
	}
	File file;
	if (!arguments.trace.empty()) {
		file.reset(std::fopen(arguments.trace.c_str(), "w"));
		if (file == nullptr) {
			std::perror(arguments.trace.c_str());
			return 2;
		}
	}
	std::signal(SIGINT, on_signal);
	std::signal(SIGTERM, on_signal);
	Tracer tracer(std::move(file));
	const auto recorder = std::make_shared<recording::Recorder>();
	if (!arguments.record.empty()) {
		const std::string trouble = recorder->open(arguments.record, recording::about_file());
		if (!trouble.empty()) {
			std::fprintf(stderr, "%s\n", trouble.c_str());
			return 2;
		}
		tracer.tap.record_to(recorder);
	}
	usb::LibusbHub hub(arguments.session, &tracer);
	const std::string fault = hub.start();
	if (!fault.empty()) {
		std::fprintf(stderr, "%s\n", fault.c_str());
		return 1;
	}
	const uint64_t begin = clocks::now_usec();
	std::vector<usb::DeviceReport> reports;
	while (stops == 0) {
		std::this_thread::sleep_for(std::chrono::milliseconds(20));
		print_messages(hub);
		reports = hub.report();
		const double passed = double(clocks::now_usec() - begin) / 1e6;
		if (has_enough(reports, arguments.frames) || (arguments.seconds > 0.0 && passed >= arguments.seconds)) {
			break;
		}
	}
	hub.stop();
	print_messages(hub);
	print_report(reports, tracer.frames);
	return tracer.frames > 0 ? 0 : 1;
}
