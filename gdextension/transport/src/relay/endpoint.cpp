// SPDX-License-Identifier: MIT
#include "endpoint.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <charconv>
#include <cstring>
#include <net/if.h>
#include <string_view>

namespace transport {

namespace {

constexpr std::array<uint8_t, 12> MAPPED{ { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF } };

size_t hash_of(const void *p_bytes, size_t p_size) {
	return std::hash<std::string_view>()({ static_cast<const char *>(p_bytes), p_size });
}

/// The number of a link, 0 if there is none.
uint32_t scope_of(const std::string &p_link) {
	uint32_t number = 0;
	const char *end = p_link.data() + p_link.size();
	const auto read = std::from_chars(p_link.data(), end, number);
	if (read.ec == std::errc() && read.ptr == end) {
		return number;
	}
	return if_nametoindex(p_link.c_str());
}

} // namespace

bool is_v4(const std::array<uint8_t, 16> &p_address) {
	return std::equal(MAPPED.begin(), MAPPED.end(), p_address.begin());
}

std::string Endpoint::address_text() const {
	std::array<char, INET6_ADDRSTRLEN> text{};
	if (is_v4(address)) {
		inet_ntop(AF_INET, address.data() + MAPPED.size(), text.data(), text.size());
	} else {
		inet_ntop(AF_INET6, address.data(), text.data(), text.size());
	}
	std::string made = text.data();
	if (scope != 0) {
		std::array<char, IF_NAMESIZE> link{};
		made += '%';
		made += if_indextoname(scope, link.data()) != nullptr ? link.data() : std::to_string(scope);
	}
	return made;
}

bool Endpoint::parse(const std::string &p_address, uint16_t p_port) {
	port = p_port;
	scope = 0;
	const size_t percent = p_address.find('%');
	if (inet_pton(AF_INET6, p_address.substr(0, percent).c_str(), address.data()) == 1) {
		scope = percent == std::string::npos ? 0 : scope_of(p_address.substr(percent + 1));
		return percent == std::string::npos || scope != 0;
	}
	std::copy(MAPPED.begin(), MAPPED.end(), address.begin());
	return inet_pton(AF_INET, p_address.c_str(), address.data() + MAPPED.size()) == 1;
}

size_t EndpointHash::operator()(const Endpoint &p_endpoint) const {
	std::array<uint8_t, 18> bytes{};
	std::copy(p_endpoint.address.begin(), p_endpoint.address.end(), bytes.begin());
	std::memcpy(bytes.data() + 16, &p_endpoint.port, sizeof(p_endpoint.port));
	return hash_of(bytes.data(), bytes.size());
}

std::array<uint8_t, 16> network_of(const Endpoint &p_endpoint) {
	std::array<uint8_t, 16> network = p_endpoint.address;
	if (!is_v4(network)) {
		std::fill(network.begin() + 8, network.end(), uint8_t(0));
	}
	return network;
}

size_t NetworkHash::operator()(const std::array<uint8_t, 16> &p_network) const {
	return hash_of(p_network.data(), p_network.size());
}

} // namespace transport
