// SPDX-License-Identifier: MIT
#pragma once

#include "usb/ftdi_protocol.hpp"

#include <cstdint>

namespace usb {

/// What a port has seen.
struct PortStatistics {
	uint64_t bytes_in = 0;
	uint64_t bytes_out = 0;
	/// Reads that ended with an error and were begun again.
	uint64_t failed_reads = 0;
	/// Writes that failed or were refused because too many were waiting.
	uint64_t failed_writes = 0;
	uint64_t halts = 0;
	FtdiStatistics ftdi;
};

} // namespace usb
