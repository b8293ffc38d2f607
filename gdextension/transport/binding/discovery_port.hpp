// SPDX-License-Identifier: MIT
#pragma once

#include "../src/discovery/discovery_socket.hpp"
#include "discovery_answer.hpp"

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace godot {

/// Asks for servers. Documented in doc_classes/DiscoveryPort.xml.
class DiscoveryPort : public RefCounted {
	GDCLASS(DiscoveryPort, RefCounted)

public:
	Error open();
	void close() { _socket.close(); }
	Error ask(const String &p_address, int64_t p_port, bool p_to_all);
	TypedArray<DiscoveryAnswer> take(int64_t p_max);
	PackedStringArray get_neighbours() const;

protected:
	static void _bind_methods();

private:
	transport::DiscoverySocket _socket;
};

} // namespace godot
