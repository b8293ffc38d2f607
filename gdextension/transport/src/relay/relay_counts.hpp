// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace transport {

/// What a server's relay has done, since the start.
struct RelayCounts {
	uint64_t sealed = 0; ///< Datagrams that were sealed.
	uint64_t opened = 0; ///< Datagrams that were opened.
	uint64_t not_opened = 0; ///< Forged, altered, or come before.
	uint64_t stray = 0; ///< From nobody who is known, or of no known kind.
	uint64_t from_port_zero = 0;
	uint64_t malformed = 0; ///< Not what ENet writes.
	uint64_t too_few_channels = 0;
	uint64_t bad_fragments = 0;
	uint64_t held_too_much = 0;
	uint64_t cookies = 0; ///< Cookies given out.
	uint64_t bad_cookies = 0;
	uint64_t handshakes = 0; ///< Handshakes answered.
	uint64_t handshakes_dropped = 0; ///< Too many at once; the client asks again.
	uint64_t handshakes_later = 0; ///< Too many tries of a password from its network.
	uint64_t wrong_passwords = 0;
	uint64_t evicted = 0; ///< Half-open connections that made room.
	uint64_t moved = 0; ///< Connections that went on from another address.
	uint64_t questions = 0; ///< Clients that look for servers have asked.
	uint64_t answers = 0; ///< Of these questions, those that were answered.
};

} // namespace transport
