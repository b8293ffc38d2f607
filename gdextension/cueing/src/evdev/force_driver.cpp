// SPDX-License-Identifier: MIT
#include "force_driver.hpp"

#include "force_device.hpp"

#include <algorithm>
#include <chrono>

namespace cueing {

namespace {

using Clock = std::chrono::steady_clock;

/// Wheels take no more than some 125 changes a second.
constexpr std::chrono::milliseconds PAUSE(8);
/// Without news for so long the wheel is let go.
constexpr std::chrono::milliseconds SILENCE(500);
/// How often a device that is not there is looked for.
constexpr std::chrono::milliseconds SEARCH(500);

} // namespace

void ForceDriver::open(const std::string &p_path) {
	close();
	_path = p_path;
	_is_stopping = false;
	_has_news = false;
	_forces = WheelForces();
	_report = ForceReport();
	_thread = std::thread([this]() { run(); });
}

void ForceDriver::close() {
	if (!_thread.joinable()) {
		return;
	}
	{
		const std::lock_guard<std::mutex> lock(_mutex);
		_is_stopping = true;
	}
	_changed.notify_all();
	_thread.join();
}

void ForceDriver::set_forces(const WheelForces &p_forces) {
	{
		const std::lock_guard<std::mutex> lock(_mutex);
		_forces = p_forces;
		_has_news = true;
	}
	_changed.notify_all();
}

void ForceDriver::set_gain(double p_gain) {
	const std::lock_guard<std::mutex> lock(_mutex);
	_gain = p_gain;
}

ForceReport ForceDriver::report() const {
	const std::lock_guard<std::mutex> lock(_mutex);
	return _report;
}

bool ForceDriver::find_device(ForceDevice &r_device, std::string &r_trouble) const {
	if (!_path.empty()) {
		r_trouble = r_device.open(_path);
		return r_device.is_open();
	}
	r_trouble = "no wheel with force feedback is plugged in";
	for (const ForceDeviceInfo &info : list_force_devices()) {
		if (!info.is_wheel()) {
			continue;
		}
		r_trouble = r_device.open(info.path);
		if (r_device.is_open()) {
			return true;
		}
		r_trouble.insert(0, info.name + ": ");
	}
	return false;
}

void ForceDriver::note(const ForceDevice &p_device, const std::string &p_trouble) {
	const std::lock_guard<std::mutex> lock(_mutex);
	_report.is_there = p_device.is_open();
	if (p_device.is_open()) {
		_report.name = p_device.info().name;
		_report.can = p_device.info().can;
	}
	_report.trouble = p_trouble;
}

void ForceDriver::run() {
	ForceDevice device;
	double gain_sent = -1.0;
	while (true) {
		std::string trouble;
		if (!device.is_open() && find_device(device, trouble)) {
			gain_sent = -1.0;
		}
		note(device, device.is_open() ? device.note() : trouble);
		WheelForces forces;
		double gain = 1.0;
		{
			std::unique_lock<std::mutex> lock(_mutex);
			const bool is_told = _changed.wait_for(
					lock, device.is_open() ? SILENCE : SEARCH, [this]() { return _is_stopping || _has_news; });
			if (_is_stopping) {
				return;
			}
			if (!device.is_open()) {
				_has_news = false;
				// News do not make a device come.
				_changed.wait_for(lock, SEARCH, [this]() { return _is_stopping; });
				continue;
			}
			_has_news = false;
			_forces = is_told ? _forces : WheelForces();
			forces = _forces;
			gain = _gain;
		}
		const Clock::time_point begin = Clock::now();
		if (gain != gain_sent) {
			device.set_gain(gain);
			gain_sent = gain;
		}
		device.apply(forces);
		std::unique_lock<std::mutex> lock(_mutex);
		_report.updates++;
		_report.longest_s = std::max(_report.longest_s, std::chrono::duration<double>(Clock::now() - begin).count());
		_changed.wait_until(lock, begin + PAUSE, [this]() { return _is_stopping; });
	}
}

} // namespace cueing
