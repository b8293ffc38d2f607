// SPDX-License-Identifier: MIT
// First process of a virtual machine: plugs emulated suits into the kernel's own USB, lets suit_stream read
// them, and looks at what the kernel's drivers do. tests/kernel reads its lines.
#include "front/usbip_server.hpp"
#include "kernel/guest.hpp"
#include "suit/suit.hpp"

#include <array>
#include <cstdio>
#include <ctime>

namespace {

using emulator::SECOND;
using emulator::Usec;

Usec monotonic() {
	timespec now{};
	clock_gettime(CLOCK_MONOTONIC, &now);
	return Usec(now.tv_sec) * SECOND + now.tv_nsec / 1000;
}

/// Without the processor's help the machine is slow, and a FTDI chip keeps 256 bytes only: few data for it.
struct Load {
	int sensors;
	int rate_hz;
};

/// One device, from when it is plugged in until it is pulled out while it streams.
void examine(const std::string &p_kind, int p_index, const Load &p_load) {
	const auto report = [&p_kind](const std::string &p_what, const std::string &p_value) {
		kernel::report(p_kind + " " + p_what, p_value);
	};
	emulator::SuitOptions options;
	options.devices = p_kind;
	options.sensors = p_load.sensors;
	const auto log = [](Usec /*p_now*/, std::size_t /*p_index*/, const std::string &p_text) {
		(void)printf("LOG %s\n", p_text.c_str());
	};
	emulator::Suit suit(options, emulator::MotionStream::still(std::size_t(p_load.sensors)), monotonic, log);
	suit.begin(monotonic());
	emulator::SuitDevice &device = suit.devices().front();
	emulator::UsbipServer server(*device.port, monotonic, p_index);
	const std::string number = p_kind == "native" ? ":1.1" : ":1.0";

	report("plugged", server.plug() ? "yes" : "no");
	report("driver before", kernel::await_driver(number, device.kernel_driver()));
	const std::string rate = "--rate=" + std::to_string(p_load.rate_hz);
	kernel::Program stream({ "/bin/suit_stream", "--seconds=5", rate });
	kernel::pause(3.0);
	report("driver meanwhile", kernel::driver(number));
	report("output", stream.finish());
	report("driver after", kernel::await_driver(number, device.kernel_driver()));

	kernel::Program second({ "/bin/suit_stream", "--seconds=6", rate });
	kernel::pause(4.0);
	server.unplug();
	report("output of the unplugged", second.finish());
	report("driver of the unplugged", kernel::driver(number));
}

} // namespace

int main() {
	kernel::set_up();
	examine("ftdi", 0, { 3, 50 });
	examine("native", 1, { 6, 100 });
	kernel::report("finished", "yes");
	kernel::power_off();
	return 0;
}
