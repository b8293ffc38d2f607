// SPDX-License-Identifier: MIT
#include "kernel/guest.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <fcntl.h>
#include <sys/mount.h>
#include <sys/reboot.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace kernel {
namespace {

void load_module(const std::string &p_path) {
	const int file = open(p_path.c_str(), O_RDONLY | O_CLOEXEC);
	const bool is_loaded = file >= 0 && (syscall(SYS_finit_module, file, "", 0) == 0 || errno == EEXIST);
	if (!is_loaded) {
		report("module", p_path + ": " + std::strerror(errno));
	}
	if (file >= 0) {
		close(file);
	}
}

} // namespace

void set_up() {
	for (const char *folder : { "/proc", "/sys", "/dev", "/tmp" }) {
		(void)mkdir(folder, 0755);
	}
	const bool is_mounted = mount("proc", "/proc", "proc", 0, nullptr) == 0 &&
			mount("sysfs", "/sys", "sysfs", 0, nullptr) == 0 && mount("devtmpfs", "/dev", "devtmpfs", 0, nullptr) == 0;
	report("mounted", is_mounted ? "yes" : std::strerror(errno));
	setenv("LD_LIBRARY_PATH", "/lib", 1);
	// What stands for hardware comes before programs.
	(void)setpriority(PRIO_PROCESS, 0, -15);
	std::ifstream order("/modules/order");
	for (std::string name; std::getline(order, name);) {
		load_module("/modules/" + name);
	}
}

void power_off() {
	(void)fflush(stdout);
	sync();
	reboot(RB_POWER_OFF);
}

void pause(double p_seconds) {
	const auto whole = time_t(p_seconds);
	const timespec time = { whole, long((p_seconds - double(whole)) * 1e9) };
	nanosleep(&time, nullptr);
}

void report(const std::string &p_name, const std::string &p_value) {
	(void)printf("RESULT %s: %s\n", p_name.c_str(), p_value.c_str());
	(void)fflush(stdout);
}

std::string driver(const std::string &p_interface) {
	std::error_code ignored;
	for (const auto &entry : std::filesystem::directory_iterator("/sys/bus/usb/devices", ignored)) {
		const std::string name = entry.path().filename().string();
		const bool is_it = name.size() > p_interface.size() &&
				name.compare(name.size() - p_interface.size(), p_interface.size(), p_interface) == 0;
		// The hub itself is "1-0:1.0".
		if (!is_it || name.find("-0:") != std::string::npos) {
			continue;
		}
		const auto link = std::filesystem::read_symlink(entry.path() / "driver", ignored);
		return ignored ? "none" : link.filename().string();
	}
	return "gone";
}

std::string await_driver(const std::string &p_interface, const std::string &p_driver) {
	constexpr int TRIES = 100;
	std::string now;
	for (int i = 0; i < TRIES && now != p_driver; i++) {
		pause(i == 0 ? 0.0 : 0.1);
		now = driver(p_interface);
	}
	return now;
}

Program::Program(std::vector<std::string> p_arguments) {
	std::array<int, 2> ends{};
	if (pipe(ends.data()) != 0) {
		return;
	}
	std::vector<char *> arguments;
	arguments.reserve(p_arguments.size() + 1);
	for (std::string &one : p_arguments) {
		arguments.push_back(one.data());
	}
	arguments.push_back(nullptr);
	_output = ends[0];
	_pid = fork();
	if (_pid == 0) {
		dup2(ends[1], STDOUT_FILENO);
		dup2(ends[1], STDERR_FILENO);
		close(ends[0]);
		(void)setpriority(PRIO_PROCESS, 0, 0);
		execv(arguments[0], arguments.data());
		_exit(127);
	}
	close(ends[1]);
}

Program::~Program() {
	if (_pid > 0) {
		finish();
	}
}

std::string Program::finish() {
	std::string text;
	std::array<char, 4096> bytes{};
	for (ssize_t size = 0; (size = read(_output, bytes.data(), bytes.size())) > 0;) {
		text.append(bytes.data(), std::size_t(size));
	}
	close(_output);
	int status = 0;
	waitpid(_pid, &status, 0);
	_pid = -1;
	for (char &letter : text) {
		letter = letter == '\n' ? '|' : letter;
	}
	return text + "exit " + std::to_string(WIFEXITED(status) ? WEXITSTATUS(status) : -1);
}

} // namespace kernel
