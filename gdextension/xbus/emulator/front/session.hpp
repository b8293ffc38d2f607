// SPDX-License-Identifier: MIT
#pragma once

#include "front/usbfs_node.hpp"
#include "suit/suit.hpp"

#include <array>
#include <fstream>

namespace emulator {

/// To be called before there are threads: signals are read by the session, so none of them may take them; and
/// what stands for hardware comes before programs, where the system allows it.
void prepare_threads();
/// LD_PRELOAD of programs that are to find the devices.
std::string preload_value();

/// Runs a suit in real time: its nodes, the program that it is for, commands, files.
class Session {
public:
	Session(const SuitOptions &p_options, MotionStream p_stream);
	~Session();
	Session(const Session &) = delete;
	Session &operator=(const Session &) = delete;

	const std::string &error() const { return _suit.error(); }
	/// Until the program has ended, or somebody says so; returns the exit code.
	int run();

private:
	void _write_log(Usec p_now, std::size_t p_index, const std::string &p_text);
	void _write_traces();
	void _plug_all(bool p_in);
	bool _start_program();
	/// Sleeps until something happens or is due.
	void _sleep();
	void _read_signals();
	/// Reads what there is of commands; `r_rest` keeps the beginning of a line.
	void _read_commands(int p_descriptor, std::string &r_rest);
	void _command(const std::string &p_line);
	/// What is due by the clock of the options.
	void _follow_schedule();

	SuitOptions _options;
	Shared _shared;
	std::ofstream _log_file;
	std::ofstream _trace_file;
	Suit _suit;
	Testbed _testbed;
	std::vector<std::unique_ptr<UsbfsNode>> _nodes;
	Usec _begin = 0;
	int _wake = -1;
	/// When the main thread goes on by itself. Under the lock.
	Usec _wakes_at = 0;
	int _signals = -1;
	int _commands = -1;
	int _standard_input = 0;
	std::array<std::string, 2> _rests;
	int _child = -1;
	int _exit_code = 0;
	bool _is_over = false;
};

} // namespace emulator
