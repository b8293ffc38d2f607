// SPDX-License-Identifier: MIT
#pragma once

#include "../sealing/cookie_jar.hpp"
#include "../sealing/fair_share.hpp"
#include "../sealing/password_tries.hpp"
#include "../sealing/return_tags.hpp"
#include "pending_table.hpp"
#include "relay_counts.hpp"
#include "relay_sink.hpp"

namespace transport {

/// A server's half of the handshakes, until a client has shown that it has the key: cookies, key
/// exchanges, and how many of them there may be.
class ServerHandshake {
public:
	/// Of each role; empty: it needs none.
	using Passwords = std::array<Bytes, messages::ROLES>;

	/// The last client that was told why it is not let in.
	struct Refusal {
		Endpoint from;
		messages::Notice what = messages::Notice::LATER;
		/// Version that the client speaks.
		uint32_t version = 0;
		/// How many were, since the start.
		uint64_t number = 0;
	};

	/// The counts must outlive it.
	ServerHandshake(uint32_t p_version, Passwords p_passwords, RelayCounts &r_counts);

	/// Other passwords, by role, from the next key exchange on.
	void set_passwords(const Passwords &p_passwords);
	/// A client asks for a cookie.
	void take_init(const Endpoint &p_from, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink);
	/// A client begins a key exchange.
	void take_start(const Endpoint &p_from, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink);
	/// A client's first sealed datagram. Returns the handshake that it completes, with what it held,
	/// or null; call finish then.
	const Pending *take_first(const Endpoint &p_from, const View &p_bytes, RelaySink &r_sink, Bytes &r_opened);
	/// A handshake is complete.
	void finish(const Endpoint &p_from);
	/// Somebody sends from an address where nobody is known: he may be a client that has moved.
	void take_stranger(const Endpoint &p_from, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink);
	/// Whether who says that he has moved to an address receives what is sent there.
	bool is_at(const Endpoint &p_from, const messages::AddressCookie &p_cookie, int64_t p_now_usec) const {
		return _cookies.is_valid(p_from, p_cookie, p_now_usec);
	}
	/// Tells a client why it is not let in.
	void refuse(const Endpoint &p_to, const messages::ClientId &p_client, messages::Notice p_what, RelaySink &r_sink);

	/// A client of a role is connected: it may come back with the tag.
	void note_connected(uint8_t p_role, const messages::ReturnTag &p_tag);
	/// A client is gone.
	void note_gone(const messages::ReturnTag &p_tag, int64_t p_now_usec) { _return_tags.leave(p_tag, p_now_usec); }
	/// Ends what has waited too long.
	void look_after(int64_t p_now_usec);

	size_t pending() const { return _pending.size(); }
	const Refusal &last_refusal() const { return _last_refusal; }

private:
	bool begin(Pending &r_pending, const messages::Start &p_start, int64_t p_now_usec);
	bool open(Pending &r_pending, const View &p_bytes, Bytes &r_opened);
	void fail(Pending &r_pending, RelaySink &r_sink);
	bool is_locked(uint8_t p_role) const { return !_passwords[p_role].empty(); }

	uint32_t _version;
	Passwords _passwords;
	RelayCounts &_counts;
	CookieJar _cookies;
	PasswordTries _password_tries;
	FairShare _starts;
	FairShare _starts_of_all;
	FairShare _strangers;
	FairShare _all_strangers;
	PendingTable _pending;
	ReturnTags _return_tags;
	Refusal _last_refusal;
};

} // namespace transport
