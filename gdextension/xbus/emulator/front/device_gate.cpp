// SPDX-License-Identifier: MIT
// A preloaded library in front of umockdev's: it lets umockdev see the emulator's devices only.
//
// umockdev keeps a table of 50 descriptors that were opened below /dev, real ones included. It also notes a failed
// open, as descriptor -1, which nobody ever closes: a window that looks for joysticks and graphics cards fills the
// table within a second, and umockdev then ends the program. Opening here what is not emulated, and failing here
// where opening would fail, keeps the table for the few nodes that it is for.
#include <cerrno>
#include <cstdarg>
#include <cstdlib>
#include <cstring>
#include <string>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/types.h>
#include <unistd.h>

namespace {

using Open = int (*)(const char *, int, ...);
using Access = int (*)(const char *, int);

/// The C library's own function, behind everything that is preloaded.
template <class T>
T find_real(const char *p_name) {
	static void *library = dlopen("libc.so.6", RTLD_LAZY);
	return reinterpret_cast<T>(dlsym(library, p_name));
}

/// The function that would be called if this library was not there: umockdev's.
template <class T>
T find_next(const char *p_name) {
	return reinterpret_cast<T>(dlsym(RTLD_NEXT, p_name));
}

/// What may be done with a file that is opened with these flags, for access().
int access_mode(int p_flags) {
	switch (p_flags & O_ACCMODE) {
		case O_WRONLY:
			return W_OK;
		case O_RDWR:
			return R_OK | W_OK;
		default:
			return R_OK;
	}
}

enum class Opener {
	EVERYTHING_ELSE,
	REAL_DEVICE,
	EMULATED_DEVICE,
	REFUSED
};

/// Who has to open a path; with REFUSED, errno says why.
Opener choose(const char *p_path, int p_flags) {
	const char *root = std::getenv("UMOCKDEV_DIR");
	if (p_path == nullptr || root == nullptr || std::strncmp(p_path, "/dev/", 5) != 0) {
		return Opener::EVERYTHING_ELSE;
	}
	static const Access real_access = find_real<Access>("access");
	const int before = errno;
	const std::string emulated = std::string(root) + p_path;
	if (real_access(emulated.c_str(), F_OK) != 0) {
		errno = before;
		return Opener::REAL_DEVICE;
	}
	if (real_access(emulated.c_str(), access_mode(p_flags)) != 0) {
		return Opener::REFUSED;
	}
	errno = before;
	return Opener::EMULATED_DEVICE;
}

/// One of the functions that open a file, as the C library has it and as umockdev has it.
class Opening {
public:
	explicit Opening(const char *p_name) : _real(find_real<Open>(p_name)), _next(find_next<Open>(p_name)) {}

	int operator()(const char *p_path, int p_flags, mode_t p_mode = 0) const {
		switch (choose(p_path, p_flags)) {
			case Opener::REFUSED:
				return -1;
			case Opener::REAL_DEVICE:
				return _real(p_path, p_flags, p_mode);
			default:
				return _next(p_path, p_flags, p_mode);
		}
	}

private:
	Open _real;
	Open _next;
};

/// The third argument of open(), which is there only if a file may be made.
mode_t read_mode(int p_flags, va_list p_arguments) {
	const bool makes = (p_flags & O_CREAT) != 0 || (p_flags & O_TMPFILE) == O_TMPFILE;
	return makes ? va_arg(p_arguments, mode_t) : 0;
}

} // namespace

#define PRELOADED extern "C" __attribute__((visibility("default")))

// The names, and the ellipses, are the C library's.
// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming)
PRELOADED int open(const char *p_path, int p_flags, ...) {
	va_list arguments;
	va_start(arguments, p_flags);
	const mode_t mode = read_mode(p_flags, arguments);
	va_end(arguments);
	static const Opening opening("open");
	return opening(p_path, p_flags, mode);
}

PRELOADED int open64(const char *p_path, int p_flags, ...) {
	va_list arguments;
	va_start(arguments, p_flags);
	const mode_t mode = read_mode(p_flags, arguments);
	va_end(arguments);
	static const Opening opening("open64");
	return opening(p_path, p_flags, mode);
}

PRELOADED int __open_2(const char *p_path, int p_flags) {
	static const Opening opening("__open_2");
	return opening(p_path, p_flags);
}

PRELOADED int __open64_2(const char *p_path, int p_flags) {
	static const Opening opening("__open64_2");
	return opening(p_path, p_flags);
}
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)
