// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// The bytes of a recording, in one piece.
struct Recording {
	std::string name;
	std::vector<uint8_t> bytes;
	/// "raw", "hex", "ftdi" for packets of an FTDI chip whose status bytes were left in (they are taken out), or
	/// "recording" for one of Dismount's own (docs/recordings.md).
	const char *kind = "raw";
};

/// Reads a file of bytes as they came from the bus, or of hexadecimal text. On failure `r_fault` says in a
/// sentence what is wrong with which file. Add other kinds of file here.
bool read_recording(const std::string &p_name, Recording &r_recording, std::string &r_fault);
