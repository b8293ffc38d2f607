// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

/// What a program does that is the first process of a virtual machine, and nobody's child.
namespace kernel {

/// Mounts /proc, /sys, /dev and loads the modules that /modules/order names.
void set_up();
/// Never comes back.
void power_off();
void pause(double p_seconds);
/// A line for the test that reads the machine's console: "RESULT name: value".
void report(const std::string &p_name, const std::string &p_value);

/// The driver of the only USB interface whose name ends so, "none" without a driver, "gone" without it.
std::string driver(const std::string &p_interface);
/// Waits until it has this driver, some seconds at most; returns the driver that it has then.
std::string await_driver(const std::string &p_interface, const std::string &p_driver);

/// A program that runs, and what it prints.
class Program {
public:
	explicit Program(std::vector<std::string> p_arguments);
	~Program();
	Program(const Program &) = delete;
	Program &operator=(const Program &) = delete;

	/// Waits for its end; returns its output with "|" between the lines.
	std::string finish();

private:
	int _pid = -1;
	int _output = -1;
};

} // namespace kernel
