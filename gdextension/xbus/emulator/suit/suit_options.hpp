// SPDX-License-Identifier: MIT
#pragma once

#include "cable/time.hpp"

#include <map>
#include <string>
#include <vector>

namespace emulator {

/// What the emulator is asked for, by options as --name=value.
struct SuitOptions {
	/// ftdi, ftdi-fast, native, two-masters, two-native-masters, mti, mti-ftdi, awinda; several with commas
	/// between.
	std::string devices = "ftdi";
	int sensors = 16;
	/// Motion stream; without one all stand still.
	std::string stream;
	/// The wearer stands in the stream's first pose until a command says otherwise.
	bool is_held = false;
	/// Names of the stream's limbs that have a sensor, in the order of the bus; empty: the first ones.
	std::vector<std::string> limbs;
	/// Sensors (from 1) that were put on each other's limb.
	int swapped_a = 0;
	int swapped_b = 0;
	/// Bits a second of the master's line.
	int baud = 460800;
	bool is_paced = true;
	uint64_t seed = 1;
	/// Mounted along the limbs' axes, and all norths the same.
	bool is_aligned = false;
	/// Lines of "w x y z degrees": rotation in the limb's frame and heading of each sensor.
	std::string mountings;
	double heading_deg = 30.0;
	double noise_deg = 0.0;
	double drift_deg_min = 0.0;

	double corrupt = 0.0;
	double drop = 0.0;
	double unplug_at_s = -1.0;
	double plug_at_s = -1.0;
	/// Numbers of messages and the error that answers them.
	std::map<uint8_t, uint8_t> errors;
	int error_every = 0;
	/// How much later than a real device it answers, ms.
	int answer_delay_ms = 0;
	/// The device id of the first master, 0: that of an Xbus Master.
	uint32_t master_id = 0;
	bool is_mute = false;
	/// As hardware does, it never waits for a processor that others use: for measuring delays alone, for it takes
	/// one and more of them for itself.
	bool is_real_time = false;
	bool has_bus_power = true;
	int battery = 230;
	int dead = 0;
	int liar = 0;
	int lie = 0;
	int first_counter = 0;

	/// Files: each sample's times; what the host asked for; commands to read.
	std::string trace;
	std::string log;
	std::string commands;
	/// Ends by itself after so many seconds; 0: never.
	double seconds = 0.0;
	/// The program may not open the devices.
	bool is_forbidden = false;
	/// The program to start, with its arguments.
	std::vector<std::string> program;

	/// Reads arguments; an empty text, or what is wrong.
	std::string parse(const std::vector<std::string> &p_arguments);

private:
	std::string _set(const std::string &p_name, const std::string &p_value);
	bool _set_number(const std::string &p_name, const std::string &p_value, std::string &r_fault);
	bool _set_text(const std::string &p_name, const std::string &p_value);
	std::string _set_special(const std::string &p_name, const std::string &p_value);
};

/// The pieces of a text between the separators.
std::vector<std::string> split(const std::string &p_text, char p_separator);
/// A number, whole (also as 0x2A) or not; false if the text is none.
bool parse_number(const std::string &p_text, double &r_value);

} // namespace emulator
