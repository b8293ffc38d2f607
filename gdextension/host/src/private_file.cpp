// SPDX-License-Identifier: MIT
#include "private_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace host {

PrivateFile::~PrivateFile() {
	close();
}

PrivateFile::Outcome PrivateFile::open(const std::string &p_path) {
	close();
	const int opened = ::open(p_path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0600);
	if (opened < 0) {
		return errno == ELOOP ? Outcome::FOREIGN : Outcome::FAILED;
	}
	struct stat status = {};
	if (fstat(opened, &status) != 0 || !S_ISREG(status.st_mode) || status.st_uid != geteuid()) {
		::close(opened);
		return Outcome::FOREIGN;
	}
	// It may have been made by hand, or copied, and be open to others.
	if ((status.st_mode & 0077) != 0 && fchmod(opened, 0600) != 0) {
		::close(opened);
		return Outcome::FOREIGN;
	}
	if (flock(opened, LOCK_EX | LOCK_NB) != 0) {
		const bool busy = errno == EWOULDBLOCK;
		::close(opened);
		return busy ? Outcome::BUSY : Outcome::FAILED;
	}
	_descriptor = opened;
	_path = p_path;
	return Outcome::OPENED;
}

std::vector<uint8_t> PrivateFile::read() const {
	std::vector<uint8_t> bytes(MAX_SIZE);
	size_t size = 0;
	while (is_open() && size < bytes.size()) {
		const ssize_t got = pread(_descriptor, bytes.data() + size, bytes.size() - size, static_cast<off_t>(size));
		if (got <= 0) {
			break;
		}
		size += static_cast<size_t>(got);
	}
	bytes.resize(size);
	return bytes;
}

bool PrivateFile::write(const std::vector<uint8_t> &p_bytes) {
	if (!is_open() || ftruncate(_descriptor, 0) != 0) {
		return false;
	}
	const ssize_t written = pwrite(_descriptor, p_bytes.data(), p_bytes.size(), 0);
	return written == static_cast<ssize_t>(p_bytes.size());
}

bool PrivateFile::remove() {
	return is_open() && unlink(_path.c_str()) == 0;
}

void PrivateFile::close() {
	if (_descriptor >= 0) {
		::close(_descriptor);
	}
	_descriptor = -1;
	_path.clear();
}

} // namespace host
