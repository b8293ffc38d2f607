// SPDX-License-Identifier: MIT
#include "fast_queue.hpp"

#include "../src/clock.hpp"

#include <algorithm>

namespace godot {

void FastQueue::put(int64_t p_peer, const transport::View &p_bytes) {
	PackedByteArray bytes;
	bytes.resize(int64_t(p_bytes.size));
	std::copy_n(p_bytes.data, p_bytes.size, bytes.ptrw());
	Ref<FastPacket> packet;
	packet.instantiate();
	packet->set_arrival_usec(transport::now_usec());
	packet->set_bytes(bytes);
	packet->set_peer(p_peer);
	_arrived.push_back(packet.ptr());
	_packets.push_back(packet);
}

TypedArray<FastPacket> FastQueue::take(int64_t p_ticks_usec) {
	const TypedArray<FastPacket> taken = _packets;
	if (!_arrived.empty()) {
		// The engine's clock and ours do not count alike.
		const int64_t offset_usec = p_ticks_usec - transport::now_usec();
		for (FastPacket *packet : _arrived) {
			packet->set_arrival_usec(packet->get_arrival_usec() + offset_usec);
		}
		_arrived.clear();
		_packets = TypedArray<FastPacket>();
	}
	return taken;
}

} // namespace godot
