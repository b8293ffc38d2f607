// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace transport {

/// An IP address and a UDP port. An IPv4 address is kept as IPv6 writes it, ::ffff:a.b.c.d.
struct Endpoint {
	std::array<uint8_t, 16> address{};
	uint32_t scope = 0;
	uint16_t port = 0;

	bool operator==(const Endpoint &p_other) const {
		return address == p_other.address && scope == p_other.scope && port == p_other.port;
	}

	/// The address as people write it, without the port; a link's own with the link, as in fe80::1%eth0.
	std::string address_text() const;
	/// Reads an IPv4 or IPv6 address, with a link by name or number (RFC 4007, 11); false if it is none,
	/// or there is no such link.
	bool parse(const std::string &p_address, uint16_t p_port);
};

struct EndpointHash {
	size_t operator()(const Endpoint &p_endpoint) const;
};

/// What addresses are counted by: a whole IPv4 address, or the first half of an IPv6 one, as who has
/// one of these has all.
std::array<uint8_t, 16> network_of(const Endpoint &p_endpoint);
/// Whether an address is an IPv4 one, in its IPv6 form.
bool is_v4(const std::array<uint8_t, 16> &p_address);

struct NetworkHash {
	size_t operator()(const std::array<uint8_t, 16> &p_network) const;
};

} // namespace transport
