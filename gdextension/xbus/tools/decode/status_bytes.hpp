// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

/// Finds out whether a capture still has the two status bytes with which every packet of an FTDI chip begins (as
/// a capture of the USB transfers has), and takes them out. How long the packets were is lost in such a file: the
/// bytes are recognised by what they are, and only if far more messages come out without them.
bool strip_status_bytes(std::vector<uint8_t> &r_bytes);
