// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>

namespace godot {

/// A datagram of the fast path. Documented in doc_classes/FastPacket.xml.
class FastPacket : public RefCounted {
	GDCLASS(FastPacket, RefCounted)

public:
	int64_t get_peer() const { return _peer; }
	void set_peer(int64_t p_peer) { _peer = p_peer; }
	PackedByteArray get_bytes() const { return _bytes; }
	void set_bytes(const PackedByteArray &p_bytes) { _bytes = p_bytes; }
	int64_t get_arrival_usec() const { return _arrival_usec; }
	void set_arrival_usec(int64_t p_arrival_usec) { _arrival_usec = p_arrival_usec; }

protected:
	static void _bind_methods();

private:
	PackedByteArray _bytes;
	int64_t _peer = 0;
	int64_t _arrival_usec = 0;
};

} // namespace godot
