// SPDX-License-Identifier: MIT
#pragma once

#include "../src/sealing/bytes.hpp"
#include "fast_packet.hpp"

#include <godot_cpp/variant/typed_array.hpp>

#include <cstdint>
#include <vector>

namespace godot {

/// What has arrived beside ENet, until a script takes it.
class FastQueue {
public:
	bool is_empty() const { return _arrived.empty(); }
	/// Adds a datagram that arrives now.
	/// @param p_peer who has sent it
	void put(int64_t p_peer, const transport::View &p_bytes);
	/// All there is, with the times of arrival by the engine's clock.
	/// @param p_ticks_usec that clock now
	TypedArray<FastPacket> take(int64_t p_ticks_usec);

private:
	TypedArray<FastPacket> _packets;
	// The same again: an Array gives its elements away more slowly.
	std::vector<FastPacket *> _arrived;
};

} // namespace godot
