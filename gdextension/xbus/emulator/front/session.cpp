// SPDX-License-Identifier: MIT
#include "front/session.hpp"

#include "clock/thread_priority.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <stdexcept>

#include <fcntl.h>
#include <linux/capability.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

namespace emulator {
namespace {

Usec monotonic() {
	timespec now{};
	clock_gettime(CLOCK_MONOTONIC, &now);
	return Usec(now.tv_sec) * SECOND + now.tv_nsec / 1000;
}

sigset_t watched() {
	sigset_t set;
	sigemptyset(&set);
	for (const int number : { SIGCHLD, SIGINT, SIGTERM, SIGHUP }) {
		sigaddset(&set, number);
	}
	return set;
}

/// As "nice" counts: lower comes first.
constexpr int HARDWARE_PRIORITY = -15;

/// umockdev finds it remarkable that a program was killed.
void pass_log(const gchar *p_domain, GLogLevelFlags p_level, const gchar *p_message, gpointer p_data) {
	if (p_message == nullptr || std::strstr(p_message, "Destroying IoctlClient") == nullptr) {
		g_log_default_handler(p_domain, p_level, p_message, p_data);
	}
}

} // namespace

void prepare_threads() {
	const sigset_t set = watched();
	pthread_sigmask(SIG_BLOCK, &set, nullptr);
	(void)setpriority(PRIO_PROCESS, 0, HARDWARE_PRIORITY);
	g_log_set_default_handler(pass_log, nullptr);
}

std::string preload_value() {
	std::error_code error;
	const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
	std::string own = (program.parent_path() / "libsuit_device_gate.so").string() + ":" + Testbed::preload();
	const char *before = std::getenv("LD_PRELOAD");
	if (before == nullptr || *before == '\0') {
		return own;
	}
	std::string all = before;
	return all.find(own) == std::string::npos ? own + ":" + all : all;
}

Session::Session(const SuitOptions &p_options, MotionStream p_stream) :
		_options(p_options),
		_suit(p_options, std::move(p_stream), monotonic,
				[this](Usec p_now, std::size_t p_index, const std::string &p_text) {
					_write_log(p_now, p_index, p_text);
				}),
		_testbed(p_options.is_forbidden),
		_begin(monotonic()),
		_wake(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
	// Wakes at the microsecond that was asked for, not some fifty later.
	prctl(PR_SET_TIMERSLACK, 1UL);
	const sigset_t set = watched();
	_signals = signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC);
	_shared.now = monotonic;
	_shared.wake_early = [this]() {
		// Every ioctl comes here, and to wake a thread costs as much as to answer one.
		if (_suit.next_event() < _wakes_at) {
			const uint64_t one = 1;
			(void)!write(_wake, &one, sizeof(one));
			_wakes_at = 0;
		}
	};
	if (!_options.log.empty()) {
		_log_file.open(_options.log);
	}
	if (!_options.trace.empty()) {
		_trace_file.open(_options.trace);
		_trace_file << "device,counter,sampled_usec,on_chip_usec,handed_over_usec\n";
	}
	if (!_options.commands.empty()) {
		_commands = open(_options.commands.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
		if (_commands < 0) {
			throw std::runtime_error(_options.commands + ": no pipe to read commands from");
		}
	}
	for (SuitDevice &one : _suit.devices()) {
		const std::size_t index = _nodes.size() + 1;
		const auto log = [this, index](const std::string &p_text) { _write_log(monotonic(), index, p_text); };
		_nodes.push_back(
				std::make_unique<UsbfsNode>(_shared, *one.port, _testbed, int(index), one.kernel_driver(), log));
	}
}

Session::~Session() {
	for (const int descriptor : { _wake, _signals, _commands }) {
		if (descriptor >= 0) {
			close(descriptor);
		}
	}
}

void Session::_write_log(Usec p_now, std::size_t p_index, const std::string &p_text) {
	if (_log_file.is_open()) {
		_log_file << p_now << ' ' << p_index << ' ' << p_text << std::endl;
	}
}

void Session::_write_traces() {
	std::size_t index = 0;
	for (SuitDevice &one : _suit.devices()) {
		index++;
		if (_trace_file.is_open()) {
			for (const SampleTrace &trace : one.traces()) {
				_trace_file << index << ',' << trace.counter << ',' << trace.sampled << ',' << trace.on_chip << ','
							<< trace.handed_over << '\n';
			}
		}
		if (!one.traces().empty()) {
			_trace_file.flush();
		}
		one.traces().clear();
	}
}

void Session::_plug_all(bool p_in) {
	for (const std::unique_ptr<UsbfsNode> &node : _nodes) {
		node->plug(p_in);
	}
}

bool Session::_start_program() {
	const std::string preload = preload_value();
	if (_options.program.empty()) {
		// For a second terminal.
		(void)printf("UMOCKDEV_DIR=%s LD_PRELOAD=%s\n", _testbed.root().c_str(), preload.c_str());
		(void)fflush(stdout);
		return true;
	}
	std::vector<char *> arguments;
	arguments.reserve(_options.program.size() + 1);
	for (std::string &one : _options.program) {
		arguments.push_back(one.data());
	}
	arguments.push_back(nullptr);
	_child = fork();
	if (_child == 0) {
		const sigset_t set = watched();
		pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
		if (_options.is_forbidden) {
			// A superuser would be let in everywhere.
			prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE);
			prctl(PR_CAPBSET_DROP, CAP_DAC_READ_SEARCH);
		}
		clocks::prefer_nobody();
		// The emulator reads commands from its own.
		const int nothing = open("/dev/null", O_RDONLY);
		dup2(nothing, STDIN_FILENO);
		setenv("LD_PRELOAD", preload.c_str(), 1);
		execvp(arguments[0], arguments.data());
		(void)fprintf(stderr, "suit_emulator: cannot start %s\n", arguments[0]);
		_exit(127);
	}
	return _child > 0;
}

int Session::run() {
	_begin = monotonic();
	_suit.begin(_begin);
	_plug_all(true);
	if (!_start_program()) {
		return 1;
	}
	while (!_is_over) {
		{
			const std::lock_guard lock(_shared.mutex);
			_suit.advance(monotonic());
			for (const std::unique_ptr<UsbfsNode> &node : _nodes) {
				node->collect();
			}
			_write_traces();
		}
		_follow_schedule();
		_sleep();
	}
	if (_child > 0) {
		kill(_child, SIGTERM);
		int status = 0;
		waitpid(_child, &status, 0);
	}
	return _exit_code;
}

void Session::_follow_schedule() {
	const double passed = double(monotonic() - _begin) * 1e-6;
	if (_options.unplug_at_s >= 0.0 && passed >= _options.unplug_at_s) {
		_options.unplug_at_s = -1.0;
		_plug_all(false);
	}
	if (_options.plug_at_s >= 0.0 && passed >= _options.plug_at_s) {
		_options.plug_at_s = -1.0;
		_plug_all(true);
	}
	if (_options.seconds > 0.0 && passed >= _options.seconds) {
		_is_over = true;
	}
}

void Session::_sleep() {
	Usec next = monotonic() + SECOND / 10;
	{
		const std::lock_guard lock(_shared.mutex);
		next = std::min(next, _suit.next_event());
		_wakes_at = next;
	}
	const Usec left = std::max<Usec>(next - monotonic(), 0);
	const timespec timeout = { time_t(left / SECOND), long(left % SECOND) * 1000 };
	pollfd waits[] = { { _wake, POLLIN, 0 }, { _signals, POLLIN, 0 }, { _commands, POLLIN, 0 },
		{ _standard_input, POLLIN, 0 } };
	if (ppoll(waits, std::size(waits), &timeout, nullptr) <= 0) {
		return;
	}
	if (waits[0].revents != 0) {
		uint64_t count = 0;
		(void)!read(_wake, &count, sizeof(count));
	}
	if (waits[1].revents != 0) {
		_read_signals();
	}
	if (waits[2].revents != 0) {
		_read_commands(_commands, _rests[0]);
	}
	if (waits[3].revents != 0) {
		_read_commands(_standard_input, _rests[1]);
	}
}

void Session::_read_signals() {
	signalfd_siginfo info{};
	while (read(_signals, &info, sizeof(info)) == ssize_t(sizeof(info))) {
		if (info.ssi_signo != SIGCHLD) {
			_is_over = true;
			_exit_code = 128 + int(info.ssi_signo);
			continue;
		}
		int status = 0;
		if (_child > 0 && waitpid(_child, &status, WNOHANG) == _child) {
			_child = -1;
			_is_over = true;
			_exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
		}
	}
}

void Session::_read_commands(int p_descriptor, std::string &r_rest) {
	std::array<char, 512> bytes{};
	const ssize_t size = read(p_descriptor, bytes.data(), bytes.size());
	if (size <= 0) {
		if (p_descriptor == _standard_input && (size == 0 || errno != EAGAIN)) {
			_standard_input = -1; // Nobody is there.
		}
		return;
	}
	r_rest.append(bytes.data(), std::size_t(size));
	for (std::size_t end = r_rest.find('\n'); end != std::string::npos; end = r_rest.find('\n')) {
		_command(r_rest.substr(0, end));
		r_rest.erase(0, end + 1);
	}
}

void Session::_command(const std::string &p_line) {
	if (p_line == "quit") {
		_is_over = true;
	} else if (p_line == "unplug" || p_line == "plug") {
		_plug_all(p_line == "plug");
	} else if (!p_line.empty()) {
		const std::lock_guard lock(_shared.mutex);
		bool is_known = false;
		const std::string fault = _suit.command(p_line, monotonic(), is_known);
		if (!is_known || !fault.empty()) {
			const std::string what = is_known ? fault : "there is no command '" + p_line + "'";
			(void)fprintf(stderr, "suit_emulator: %s\n", what.c_str());
		}
	}
}

} // namespace emulator
