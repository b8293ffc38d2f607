// SPDX-License-Identifier: MIT
#include "cookie_jar.hpp"

#include <cstdlib>
#include <sodium.h>

namespace transport {

namespace {

/// Of what the cookies of addresses are made: of no role that a client can have.
const messages::Init FOR_ADDRESS{ 0, 0xFF, {} };

} // namespace

CookieJar::CookieJar() {
	// Chooses what suits the processor; any number of times, from any thread.
	if (sodium_init() < 0) {
		std::abort();
	}
	randombytes_buf(_key.data(), _key.size());
}

messages::Cookie CookieJar::make(const Endpoint &p_client, const messages::Init &p_init, int64_t p_now_usec) const {
	return of_period(p_client, p_init, p_now_usec / PERIOD_USEC);
}

bool CookieJar::is_valid(const Endpoint &p_client, const messages::Start &p_start, int64_t p_now_usec) const {
	messages::Init init;
	init.version = p_start.version;
	init.role = p_start.role;
	init.client = p_start.client;
	return is_recent(p_client, init, p_start.cookie, p_now_usec);
}

/// Whether a cookie, or its beginning, is of this period or of the one before.
bool CookieJar::is_recent(
		const Endpoint &p_client, const messages::Init &p_init, const View &p_cookie, int64_t p_now_usec) const {
	for (const int64_t period : { p_now_usec / PERIOD_USEC, p_now_usec / PERIOD_USEC - 1 }) {
		const messages::Cookie expected = of_period(p_client, p_init, period);
		if (sodium_memcmp(expected.data(), p_cookie.data, p_cookie.size) == 0) {
			return true;
		}
	}
	return false;
}

messages::Cookie CookieJar::of_period(const Endpoint &p_client, const messages::Init &p_init, int64_t p_period) const {
	std::array<uint8_t, 43> text{};
	std::memcpy(text.data(), p_client.address.data(), 16);
	std::memcpy(text.data() + 16, &p_client.scope, 4);
	std::memcpy(text.data() + 20, &p_client.port, 2);
	std::memcpy(text.data() + 22, p_init.client.data(), 8);
	std::memcpy(text.data() + 30, &p_init.version, 4);
	text[34] = p_init.role;
	std::memcpy(text.data() + 35, &p_period, 8);
	static_assert(sizeof(messages::Cookie) >= crypto_generichash_BYTES_MIN);
	messages::Cookie made{};
	crypto_generichash(made.data(), made.size(), text.data(), text.size(), _key.data(), _key.size());
	return made;
}

messages::AddressCookie CookieJar::make(const Endpoint &p_client, int64_t p_now_usec) const {
	return read_array<12>(of_period(p_client, FOR_ADDRESS, p_now_usec / PERIOD_USEC).data());
}

bool CookieJar::is_valid(const Endpoint &p_client, const messages::AddressCookie &p_cookie, int64_t p_now_usec) const {
	return is_recent(p_client, FOR_ADDRESS, p_cookie, p_now_usec);
}

} // namespace transport
