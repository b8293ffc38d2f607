// SPDX-License-Identifier: MIT
#include "discovery_port.hpp"

#include <algorithm>

namespace godot {

Error DiscoveryPort::open() {
	return _socket.open() ? OK : ERR_CANT_CREATE;
}

Error DiscoveryPort::ask(const String &p_address, int64_t p_port, bool p_to_all) {
	transport::Endpoint to;
	if (p_port < 1 || p_port > 65535 || !to.parse(p_address.utf8().get_data(), uint16_t(p_port))) {
		return ERR_INVALID_PARAMETER;
	}
	return _socket.ask(to, p_to_all) ? OK : ERR_UNAVAILABLE;
}

TypedArray<DiscoveryAnswer> DiscoveryPort::take(int64_t p_max) {
	TypedArray<DiscoveryAnswer> made;
	const auto add = [&made](const transport::Endpoint &p_from, const transport::View &p_body, int64_t p_delay_usec) {
		PackedByteArray body;
		body.resize(int64_t(p_body.size));
		std::copy_n(p_body.data, p_body.size, body.ptrw());
		Ref<DiscoveryAnswer> answer;
		answer.instantiate();
		answer->set_address(String(p_from.address_text().c_str()));
		answer->set_port(p_from.port);
		answer->set_body(body);
		answer->set_delay_usec(p_delay_usec);
		made.push_back(answer);
	};
	_socket.take(p_max > 0 ? size_t(p_max) : 0, add);
	return made;
}

PackedStringArray DiscoveryPort::get_neighbours() const {
	PackedStringArray made;
	for (const transport::Endpoint &neighbour : transport::DiscoverySocket::neighbours()) {
		made.push_back(String(neighbour.address_text().c_str()));
	}
	return made;
}

void DiscoveryPort::_bind_methods() {
	ClassDB::bind_method(D_METHOD("open"), &DiscoveryPort::open);
	ClassDB::bind_method(D_METHOD("close"), &DiscoveryPort::close);
	ClassDB::bind_method(D_METHOD("ask", "address", "port", "to_all"), &DiscoveryPort::ask);
	ClassDB::bind_method(D_METHOD("take", "max"), &DiscoveryPort::take);
	ClassDB::bind_method(D_METHOD("get_neighbours"), &DiscoveryPort::get_neighbours);
}

} // namespace godot
