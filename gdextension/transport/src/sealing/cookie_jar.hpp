// SPDX-License-Identifier: MIT
#pragma once

#include "../relay/endpoint.hpp"
#include "messages.hpp"

namespace transport {

/// Makes and checks cookies, and keeps none: a client shows by its cookie that it receives what is
/// sent to the address that it names, before the server spends anything on it.
class CookieJar {
public:
	/// A cookie is good for one to two times as long, us.
	static constexpr int64_t PERIOD_USEC = 8000000;

	CookieJar();
	messages::Cookie make(const Endpoint &p_client, const messages::Init &p_init, int64_t p_now_usec) const;
	bool is_valid(const Endpoint &p_client, const messages::Start &p_start, int64_t p_now_usec) const;
	/// The same for an address from which somebody wants to go on.
	messages::AddressCookie make(const Endpoint &p_client, int64_t p_now_usec) const;
	bool is_valid(const Endpoint &p_client, const messages::AddressCookie &p_cookie, int64_t p_now_usec) const;

private:
	bool is_recent(
			const Endpoint &p_client, const messages::Init &p_init, const View &p_cookie, int64_t p_now_usec) const;
	messages::Cookie of_period(const Endpoint &p_client, const messages::Init &p_init, int64_t p_period) const;

	std::array<uint8_t, 32> _key{};
};

} // namespace transport
