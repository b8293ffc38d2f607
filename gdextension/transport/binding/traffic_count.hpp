// SPDX-License-Identifier: MIT
#pragma once

#include "../src/relay/server_relay.hpp"

#include <godot_cpp/variant/dictionary.hpp>

#include <cstddef>
#include <cstdint>

namespace godot {

/// Counts what a socket sends to the network and receives from it.
class TrafficCount {
public:
	/// What IPv4 and UDP add to a datagram, bytes.
	static constexpr uint64_t IP_AND_UDP = 28;

	void note_sent(size_t p_size) {
		_sent_bytes += p_size + IP_AND_UDP;
		_sent_datagrams++;
	}
	void note_received(size_t p_size) {
		_received_bytes += p_size + IP_AND_UDP;
		_received_datagrams++;
	}
	Dictionary describe() const;

private:
	uint64_t _sent_bytes = 0;
	uint64_t _sent_datagrams = 0;
	uint64_t _received_bytes = 0;
	uint64_t _received_datagrams = 0;
};

/// Adds what a server's relay has counted.
void describe_server(const transport::ServerRelay &p_server, Dictionary &r_stats);

} // namespace godot
