// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/string.hpp>

namespace godot {

/// What a server says of itself. Documented in doc_classes/DiscoveryAnswer.xml.
class DiscoveryAnswer : public RefCounted {
	GDCLASS(DiscoveryAnswer, RefCounted)

public:
	String get_address() const { return _address; }
	void set_address(const String &p_address) { _address = p_address; }
	int64_t get_port() const { return _port; }
	void set_port(int64_t p_port) { _port = p_port; }
	PackedByteArray get_body() const { return _body; }
	void set_body(const PackedByteArray &p_body) { _body = p_body; }
	int64_t get_delay_usec() const { return _delay_usec; }
	void set_delay_usec(int64_t p_delay_usec) { _delay_usec = p_delay_usec; }

protected:
	static void _bind_methods();

private:
	String _address;
	int64_t _port = 0;
	PackedByteArray _body;
	int64_t _delay_usec = 0;
};

} // namespace godot
