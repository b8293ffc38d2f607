// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace host {

/// A small file that nobody but its owner can read and that one process at a time has open.
///
/// The lock is the system's (flock): it ends with the process, however that ends. The file is
/// created with mode 0600; symbolic links are not followed.
class PrivateFile {
public:
	/// Bytes that are read at most.
	static constexpr size_t MAX_SIZE = 4096;

	/// What became of opening it.
	enum class Outcome {
		OPENED,
		/// Another process, or another object of this one, has it open.
		BUSY,
		/// It belongs to another user, or is no plain file.
		FOREIGN,
		/// The system does not open or create it.
		FAILED,
	};

	PrivateFile() = default;
	~PrivateFile();
	PrivateFile(const PrivateFile &) = delete;
	PrivateFile &operator=(const PrivateFile &) = delete;

	/// Opens and locks a file, and creates it where there is none; its folder must exist.
	Outcome open(const std::string &p_path);
	bool is_open() const { return _descriptor >= 0; }
	/// What it holds, MAX_SIZE bytes at most; empty if it is not open.
	std::vector<uint8_t> read() const;
	/// Replaces what it holds. False if it is not open or the disk is full.
	bool write(const std::vector<uint8_t> &p_bytes);
	/// Removes the file from its folder while it is open and locked. False if that fails.
	bool remove();
	/// Unlocks and closes it.
	void close();

private:
	int _descriptor = -1;
	std::string _path;
};

} // namespace host
