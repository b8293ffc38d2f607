// SPDX-License-Identifier: MIT
// Force feedback at a wheel that is not there, by umockdev's handlers of requests.
#include <evdev/force_device.hpp>
#include <evdev/force_driver.hpp>

#include "check.hpp"
#include "fake_wheel.hpp"

#include <chrono>
#include <functional>
#include <thread>

#include <linux/capability.h>
#include <sys/syscall.h>

using namespace cueing;

namespace {

UMockdevTestbed *testbed() {
	static UMockdevTestbed *made = umockdev_testbed_new();
	return made;
}

/// Waits for what another thread does.
bool comes(const std::function<bool()> &p_holds) {
	for (int i = 0; i < 4000; i++) {
		if (p_holds()) {
			return true;
		}
		std::this_thread::sleep_for(std::chrono::milliseconds(5));
	}
	return false;
}

/// Takes a superuser's right to open everything, and gives it back.
class Commoner {
public:
	Commoner() { set(0); }
	~Commoner() { set(~0U); }
	Commoner(const Commoner &) = delete;
	Commoner &operator=(const Commoner &) = delete;

private:
	static void set(uint32_t p_keep) {
		__user_cap_header_struct head{ _LINUX_CAPABILITY_VERSION_3, 0 };
		__user_cap_data_struct data[2] = {};
		syscall(SYS_capget, &head, data);
		const uint32_t open_all = (1U << CAP_DAC_OVERRIDE) | (1U << CAP_DAC_READ_SEARCH);
		data[0].effective = (data[0].effective & ~open_all) | (data[0].permitted & open_all & p_keep);
		syscall(SYS_capset, &head, data);
	}
};

} // namespace

TEST(devices_are_listed_with_what_they_can) {
	FakeWheel wheel(testbed());
	FakeWheel pad(testbed());
	FakeWheel keyboard(testbed());
	pad.name = "Fake Pad";
	pad.bits = { FF_RUMBLE, FF_PERIODIC, FF_SINE, FF_GAIN };
	keyboard.bits = {};
	CHECK(wheel.plug().empty());
	CHECK(pad.plug().empty());
	CHECK(keyboard.plug().empty());
	const std::vector<ForceDeviceInfo> found = list_force_devices();
	CHECK(found.size() == 2);
	if (found.size() == 2) {
		CHECK(found[0].path == wheel.path());
		CHECK(found[0].name == "Fake Wheel");
		CHECK(found[0].vendor == 0x046d);
		CHECK(found[0].product == 0xc24f);
		CHECK(found[0].is_wheel());
		CHECK(found[0].error.empty());
		CHECK(!found[1].is_wheel());
		CHECK(found[1].can[std::size_t(ForceKind::PERIODIC)]);
		CHECK(!found[1].can[std::size_t(ForceKind::DAMPER)]);
	}
}

TEST(effects_are_uploaded_byte_by_byte_and_played) {
	FakeWheel wheel(testbed());
	CHECK(wheel.plug().empty());
	ForceDevice device;
	CHECK(device.open(wheel.path()).empty());
	CHECK(device.room() == 16);
	CHECK(device.set_gain(0.5));
	WheelForces forces;
	forces.constant = -0.5;
	forces.spring = 0.25;
	forces.spring_dead_band = 0.1;
	forces.damper = 1.0;
	forces.periodic = 0.5;
	forces.periodic_hz = 25.0;
	CHECK(device.apply(forces));
	const std::vector<ff_effect> sent = wheel.uploads();
	CHECK(sent.size() == 4);
	if (sent.size() != 4) {
		return;
	}
	ff_effect constant{};
	constant.type = 0x52;
	constant.id = 0;
	constant.direction = 0xC000;
	constant.u.constant.level = -16384;
	CHECK(effect_bytes(sent[0]) == effect_bytes(constant));
	ff_effect spring{};
	spring.type = 0x53;
	spring.id = 1;
	spring.direction = 0xC000;
	spring.u.condition[0] = { 65535, 65535, 8192, 8192, 6554, 0 };
	CHECK(effect_bytes(sent[1]) == effect_bytes(spring));
	ff_effect damper{};
	damper.type = 0x55;
	damper.id = 2;
	damper.direction = 0xC000;
	damper.u.condition[0] = { 65535, 65535, 32767, 32767, 0, 0 };
	CHECK(effect_bytes(sent[2]) == effect_bytes(damper));
	ff_effect periodic{};
	periodic.type = 0x51;
	periodic.id = 3;
	periodic.direction = 0xC000;
	periodic.u.periodic.waveform = 0x5a;
	periodic.u.periodic.period = 40;
	periodic.u.periodic.magnitude = 16384;
	CHECK(effect_bytes(sent[3]) == effect_bytes(periodic));

	const std::vector<input_event> events = wheel.events();
	const int expected[][2] = { { 0x61, 0 }, { 0x60, 32768 }, { 0, 1 }, { 1, 1 }, { 2, 1 }, { 3, 1 } };
	CHECK(events.size() == std::size(expected));
	for (std::size_t i = 0; i < std::min(events.size(), std::size(expected)); i++) {
		CHECK(events[i].type == EV_FF);
		CHECK(events[i].code == expected[i][0]);
		CHECK(events[i].value == expected[i][1]);
	}
}

TEST(only_what_changes_is_sent_and_all_is_erased_at_the_end) {
	FakeWheel wheel(testbed());
	CHECK(wheel.plug().empty());
	{
		ForceDevice device;
		CHECK(device.open(wheel.path()).empty());
		WheelForces forces;
		CHECK(device.apply(forces));
		CHECK(wheel.uploads().empty());
		forces.spring = 0.5;
		CHECK(device.apply(forces));
		CHECK(device.apply(forces));
		CHECK(wheel.uploads().size() == 1);
		forces.constant = 0.3;
		CHECK(device.apply(forces));
		forces.constant = 0.0;
		CHECK(device.apply(forces));
		const std::vector<ff_effect> sent = wheel.uploads();
		CHECK(sent.size() == 3);
		CHECK(sent.back().id == 1);
		CHECK(sent.back().u.constant.level == 0);
		CHECK(wheel.effects().size() == 2);
	}
	CHECK(wheel.effects().empty());
}

TEST(forces_that_are_none_do_nothing) {
	WheelForces forces;
	forces.constant = std::nan("");
	forces.damper = -3.0;
	forces.spring = 7.0;
	forces.periodic = 1.0;
	forces.periodic_hz = 0.0;
	CHECK(make_effect(ForceKind::CONSTANT, forces, 0).u.constant.level == 0);
	CHECK(make_effect(ForceKind::DAMPER, forces, 0).u.condition[0].right_coeff == 0);
	CHECK(make_effect(ForceKind::SPRING, forces, 0).u.condition[0].right_coeff == 32767);
	CHECK(make_effect(ForceKind::PERIODIC, forces, 0).u.periodic.period == 2000);
	CHECK(is_idle(ForceKind::CONSTANT, forces));
	CHECK(!is_idle(ForceKind::SPRING, forces));
}

TEST(a_device_with_little_room_keeps_the_important_forces) {
	FakeWheel wheel(testbed());
	wheel.room = 2;
	CHECK(wheel.plug().empty());
	ForceDevice device;
	CHECK(device.open(wheel.path()).empty());
	WheelForces forces;
	forces.constant = 0.5;
	forces.spring = 0.5;
	forces.damper = 0.5;
	CHECK(device.apply(forces));
	CHECK(wheel.effects().size() == 2);
	CHECK(device.note().find("no damper force: it has room for 2 effects") != std::string::npos);
	forces.constant = 0.6;
	CHECK(device.apply(forces));
	CHECK(wheel.uploads().back().u.constant.level == 19660);
}

TEST(a_device_without_rights_is_named_with_its_remedy) {
	FakeWheel wheel(testbed());
	CHECK(wheel.plug().empty());
	wheel.forbid();
	const Commoner commoner;
	ForceDevice device;
	const std::string error = device.open(wheel.path());
	CHECK(error.find(wheel.path()) != std::string::npos);
	CHECK(error.find("60-dismount-wheels.rules") != std::string::npos);
	CHECK(error.find("group input") != std::string::npos);
	CHECK(!device.is_open());
	const std::vector<ForceDeviceInfo> found = list_force_devices();
	CHECK(found.size() == 1);
	CHECK(!found.empty() && found[0].error == error);
	ForceDriver driver;
	driver.open("");
	CHECK(comes([&]() { return driver.report().trouble.find("group input") != std::string::npos; }));
	CHECK(!driver.report().is_there);
}

TEST(what_is_no_wheel_is_refused) {
	FakeWheel mouse(testbed());
	mouse.bits = { FF_RUMBLE };
	CHECK(mouse.plug().empty());
	ForceDevice device;
	CHECK(device.open(mouse.path()).find("no force feedback") != std::string::npos);
	CHECK(device.open("/dev/input/event777").find("event777") != std::string::npos);
	CHECK(!device.apply(WheelForces()));
}

TEST(a_wheel_that_is_pulled_out_is_taken_again) {
	FakeWheel wheel(testbed());
	ForceDriver driver;
	driver.open("");
	CHECK(comes([&]() { return driver.report().trouble.find("no wheel") != std::string::npos; }));
	CHECK(wheel.plug().empty());
	CHECK(comes([&]() { return driver.report().is_there; }));
	CHECK(driver.report().name == "Fake Wheel");
	WheelForces forces;
	forces.constant = 0.5;
	const auto keeps_pushing = [&]() {
		driver.set_forces(forces);
		const std::map<int, ff_effect> effects = wheel.effects();
		return !effects.empty() && effects.begin()->second.u.constant.level == 16384;
	};
	CHECK(comes(keeps_pushing));
	wheel.unplug();
	forces.constant = 0.7;
	CHECK(comes([&]() {
		forces.constant += forces.constant < 0.9 ? 0.001 : -0.2;
		driver.set_forces(forces);
		return !driver.report().is_there;
	}));
	CHECK(wheel.plug().empty());
	forces.constant = 0.5;
	CHECK(comes(keeps_pushing));
	CHECK(driver.report().trouble.empty());
	CHECK(driver.report().longest_s > 0.0);
	// Who is silent lets go.
	CHECK(comes([&]() { return wheel.effects().begin()->second.u.constant.level == 0; }));
	driver.close();
	CHECK(wheel.effects().empty());
}

TEST(a_device_that_dies_while_it_is_used_is_closed) {
	FakeWheel wheel(testbed());
	CHECK(wheel.plug().empty());
	ForceDevice device;
	CHECK(device.open(wheel.path()).empty());
	wheel.die();
	WheelForces forces;
	forces.constant = 0.5;
	CHECK(!device.apply(forces));
	CHECK(!device.is_open());
	CHECK(!device.set_gain(1.0));
}

int main(int /*p_count*/, char **p_arguments) {
	enter_umockdev(p_arguments);
	const int result = check::run_all();
	g_object_unref(testbed());
	return result;
}
