// SPDX-License-Identifier: MIT
#pragma once

#include "wheel_forces.hpp"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace cueing {

class ForceDevice;

struct ForceReport {
	/// The device is there.
	bool is_there = false;
	std::string name;
	std::array<bool, FORCE_KINDS> can{};
	/// What does not work, with what helps; empty if all does.
	std::string trouble;
	/// Changes that went to the device.
	uint64_t updates = 0;
	/// The longest that one took, s.
	double longest_s = 0.0;
};

/// Keeps a wheel doing what it was told last, in a thread of its own: a driver may take milliseconds. A wheel that is
/// pulled out is taken again when it comes back. Where nothing new is said for a while, the wheel is let go.
class ForceDriver {
public:
	ForceDriver() = default;
	~ForceDriver() { close(); }
	ForceDriver(const ForceDriver &) = delete;
	ForceDriver &operator=(const ForceDriver &) = delete;

	/// Takes the device of a path, or the first wheel if it is empty, as soon as it is there.
	void open(const std::string &p_path);
	void close();
	bool is_open() const { return _thread.joinable(); }
	void set_forces(const WheelForces &p_forces);
	void set_gain(double p_gain);
	ForceReport report() const;

private:
	void run();
	bool find_device(ForceDevice &r_device, std::string &r_trouble) const;
	void note(const ForceDevice &p_device, const std::string &p_trouble);

	std::string _path;
	std::thread _thread;
	mutable std::mutex _mutex;
	std::condition_variable _changed;
	bool _is_stopping = false;
	bool _has_news = false;
	WheelForces _forces;
	double _gain = 1.0;
	ForceReport _report;
};

} // namespace cueing
