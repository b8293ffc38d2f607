// SPDX-License-Identifier: MIT
#include "discovery_answer.hpp"

namespace godot {

void DiscoveryAnswer::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_address"), &DiscoveryAnswer::get_address);
	ClassDB::bind_method(D_METHOD("set_address", "address"), &DiscoveryAnswer::set_address);
	ClassDB::bind_method(D_METHOD("get_port"), &DiscoveryAnswer::get_port);
	ClassDB::bind_method(D_METHOD("set_port", "port"), &DiscoveryAnswer::set_port);
	ClassDB::bind_method(D_METHOD("get_body"), &DiscoveryAnswer::get_body);
	ClassDB::bind_method(D_METHOD("set_body", "body"), &DiscoveryAnswer::set_body);
	ClassDB::bind_method(D_METHOD("get_delay_usec"), &DiscoveryAnswer::get_delay_usec);
	ClassDB::bind_method(D_METHOD("set_delay_usec", "delay_usec"), &DiscoveryAnswer::set_delay_usec);
	ADD_PROPERTY(PropertyInfo(Variant::STRING, "address"), "set_address", "get_address");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "port"), "set_port", "get_port");
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_BYTE_ARRAY, "body"), "set_body", "get_body");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "delay_usec"), "set_delay_usec", "get_delay_usec");
}

} // namespace godot
