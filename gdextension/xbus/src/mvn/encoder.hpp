// SPDX-License-Identifier: MIT
#pragma once

#include "mvn/datagram.hpp"

#include <cstdint>
#include <vector>

namespace mvn {

using Bytes = std::vector<uint8_t>;

/// Bytes of a datagram that pass every network in one piece.
constexpr std::size_t MAX_SENT = 1400;

/// Writes the datagrams of one sample, as MVN 2019 and later send them: type, sample, time code, character and
/// counts are the head's, everything else of the head follows from the content. Empty where the content does not
/// fit its type.
std::vector<Bytes> encode(const Content &p_content, std::size_t p_most = MAX_SENT);

} // namespace mvn
