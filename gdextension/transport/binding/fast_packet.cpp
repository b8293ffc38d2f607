// SPDX-License-Identifier: MIT
#include "fast_packet.hpp"

namespace godot {

void FastPacket::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_peer"), &FastPacket::get_peer);
	ClassDB::bind_method(D_METHOD("set_peer", "peer"), &FastPacket::set_peer);
	ClassDB::bind_method(D_METHOD("get_bytes"), &FastPacket::get_bytes);
	ClassDB::bind_method(D_METHOD("set_bytes", "bytes"), &FastPacket::set_bytes);
	ClassDB::bind_method(D_METHOD("get_arrival_usec"), &FastPacket::get_arrival_usec);
	ClassDB::bind_method(D_METHOD("set_arrival_usec", "arrival_usec"), &FastPacket::set_arrival_usec);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "peer"), "set_peer", "get_peer");
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_BYTE_ARRAY, "bytes"), "set_bytes", "get_bytes");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "arrival_usec"), "set_arrival_usec", "get_arrival_usec");
}

} // namespace godot
