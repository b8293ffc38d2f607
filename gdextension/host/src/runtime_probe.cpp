// SPDX-License-Identifier: MIT
#include "runtime_probe.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace host {

namespace {

// What OpenXR 1.0 (openxr.h, openxr_loader_negotiation.h) lays down of the calls that are made here.
using Function = void (*)();
using Result = int32_t;
using Handle = uint64_t;

constexpr uint64_t API_1_0 = uint64_t(1) << 48;
constexpr uint64_t API_LAST = UINT64_MAX;
constexpr int32_t TYPE_INSTANCE_CREATE_INFO = 3;
constexpr int32_t TYPE_SYSTEM_GET_INFO = 4;
constexpr int32_t FORM_FACTOR_HEADSET = 1;
constexpr uint32_t LOADER_INFO = 1;
constexpr uint32_t RUNTIME_REQUEST = 3;
constexpr size_t NAME_BYTES = 128;

using GetAddress = Result (*)(Handle, const char *, Function *);

struct LoaderInfo {
	uint32_t type = LOADER_INFO;
	uint32_t version = 1;
	size_t size = sizeof(LoaderInfo);
	uint32_t oldest_interface = 1;
	uint32_t newest_interface = 1;
	uint64_t oldest_api = API_1_0;
	uint64_t newest_api = API_LAST;
};

struct RuntimeRequest {
	uint32_t type = RUNTIME_REQUEST;
	uint32_t version = 1;
	size_t size = sizeof(RuntimeRequest);
	uint32_t interface = 0;
	uint64_t api = 0;
	GetAddress get_address = nullptr;
};

struct InstanceCreateInfo {
	int32_t type = TYPE_INSTANCE_CREATE_INFO;
	const void *next = nullptr;
	uint64_t flags = 0;
	char application[NAME_BYTES] = "Dismount, asking for a headset";
	uint32_t application_version = 1;
	char engine[NAME_BYTES] = "";
	uint32_t engine_version = 0;
	uint64_t api = API_1_0;
	uint32_t layer_count = 0;
	const char *const *layers = nullptr;
	uint32_t extension_count = 0;
	const char *const *extensions = nullptr;
};

struct SystemGetInfo {
	int32_t type = TYPE_SYSTEM_GET_INFO;
	const void *next = nullptr;
	int32_t form_factor = FORM_FACTOR_HEADSET;
};

using Negotiate = Result (*)(const LoaderInfo *, RuntimeRequest *);
using CreateInstance = Result (*)(const InstanceCreateInfo *, Handle *);
using GetSystem = Result (*)(Handle, const SystemGetInfo *, uint64_t *);

template <typename T>
T find(GetAddress p_get, Handle p_instance, const char *p_name) {
	Function found = nullptr;
	return p_get(p_instance, p_name, &found) >= 0 ? reinterpret_cast<T>(found) : nullptr;
}

RuntimeProbe::Answer ask(const char *p_library) {
	using Answer = RuntimeProbe::Answer;
	void *library = dlopen(p_library, RTLD_NOW | RTLD_LOCAL);
	auto negotiate = library != nullptr
			? reinterpret_cast<Negotiate>(dlsym(library, "xrNegotiateLoaderRuntimeInterface"))
			: nullptr;
	const LoaderInfo info;
	RuntimeRequest request;
	if (negotiate == nullptr || negotiate(&info, &request) < 0 || request.get_address == nullptr) {
		return Answer::NO_LIBRARY;
	}
	const GetAddress get = request.get_address;
	const auto create = find<CreateInstance>(get, 0, "xrCreateInstance");
	const InstanceCreateInfo wanted;
	Handle instance = 0;
	if (create == nullptr || create(&wanted, &instance) < 0) {
		return Answer::NO_SERVICE;
	}
	const auto get_system = find<GetSystem>(get, instance, "xrGetSystem");
	const SystemGetInfo headset;
	uint64_t system = 0;
	if (get_system == nullptr || get_system(instance, &headset, &system) < 0) {
		return Answer::NO_HEADSET;
	}
	return Answer::READY;
}

/// The child: it has nothing of its parent's but memory, and leaves without tidying that up.
[[noreturn]] void run_child(const char *p_library, unsigned p_limit_s) {
	for (const int number : { SIGTERM, SIGINT, SIGHUP, SIGALRM, SIGSEGV, SIGABRT }) {
		std::signal(number, SIG_DFL);
	}
	// Should the parent be gone by then.
	alarm(p_limit_s);
	const int nowhere = open("/dev/null", O_RDWR);
	for (const int stream : { STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO }) {
		dup2(nowhere, stream);
	}
	// Sockets of the parent must end when it closes them.
	const long last = sysconf(_SC_OPEN_MAX);
	for (int descriptor = STDERR_FILENO + 1; descriptor < (last < 4096 ? last : 4096); ++descriptor) {
		close(descriptor);
	}
	_exit(static_cast<int>(ask(p_library)));
}

} // namespace

RuntimeProbe::~RuntimeProbe() {
	end();
}

bool RuntimeProbe::start(const std::string &p_library, std::chrono::milliseconds p_patience) {
	if (_child > 0) {
		return false;
	}
	const auto limit_s = static_cast<unsigned>(p_patience.count() / 1000 + 2);
	_child = fork();
	if (_child == 0) {
		run_child(p_library.c_str(), limit_s);
	}
	_answer = _child > 0 ? Answer::PENDING : Answer::NONE;
	_until = std::chrono::steady_clock::now() + p_patience;
	return _child > 0;
}

RuntimeProbe::Answer RuntimeProbe::poll() {
	if (_child <= 0) {
		return _answer;
	}
	int status = 0;
	const pid_t ended = waitpid(_child, &status, WNOHANG);
	if (ended == -1) {
		// Somebody else has taken what it answered, and its number may be another's by now.
		_child = -1;
		_answer = Answer::NO_SERVICE;
	} else if (ended == _child) {
		_child = -1;
		// What crashes it would crash us as well.
		_answer = WIFEXITED(status) ? static_cast<Answer>(WEXITSTATUS(status)) : Answer::NO_SERVICE;
	} else if (std::chrono::steady_clock::now() > _until) {
		end();
		_answer = Answer::STALLED;
	}
	return _answer;
}

void RuntimeProbe::end() {
	if (_child > 0) {
		kill(_child, SIGKILL);
		waitpid(_child, nullptr, 0);
	}
	_child = -1;
}

} // namespace host
