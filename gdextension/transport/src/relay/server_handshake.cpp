// SPDX-License-Identifier: MIT
#include "server_handshake.hpp"

#include <utility>

namespace transport {

namespace {

using messages::Notice;

/// Key exchanges, of which each costs 0.1 ms: of one network, and of all.
constexpr double STARTS_PER_S = 1500.0;
constexpr double ALL_STARTS_PER_S = 2000.0;
/// Answers to those who send from where nobody is known: of one network, and of all.
constexpr double STRANGERS_PER_S = 200.0;
constexpr double ALL_STRANGERS_PER_S = 2000.0;

} // namespace

ServerHandshake::ServerHandshake(uint32_t p_version, Passwords p_passwords, RelayCounts &r_counts) :
		_version(p_version),
		_passwords(std::move(p_passwords)),
		_counts(r_counts),
		_starts(STARTS_PER_S),
		_starts_of_all(ALL_STARTS_PER_S),
		_strangers(STRANGERS_PER_S),
		_all_strangers(ALL_STRANGERS_PER_S) {}

void ServerHandshake::set_passwords(const Passwords &p_passwords) {
	if (p_passwords != _passwords) {
		_passwords = p_passwords;
		_return_tags.clear();
	}
}

void ServerHandshake::take_init(const Endpoint &p_from, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink) {
	messages::Init init;
	if (!init.decode(p_bytes)) {
		_counts.stray++;
		return;
	}
	if (init.version != _version) {
		_last_refusal.version = init.version;
		refuse(p_from, init.client, Notice::OTHER_VERSION, r_sink);
		return;
	}
	if (init.role >= messages::ROLES) {
		_counts.stray++;
		return;
	}
	messages::CookieReply reply;
	reply.client = init.client;
	reply.cookie = _cookies.make(p_from, init, p_now_usec);
	reply.locked = is_locked(init.role);
	_counts.cookies++;
	r_sink.to_outer(p_from, reply.encode());
}

void ServerHandshake::take_start(const Endpoint &p_from, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink) {
	messages::Start start;
	if (!start.decode(p_bytes) || !_cookies.is_valid(p_from, start, p_now_usec)) {
		_counts.bad_cookies++;
		return;
	}
	Pending *pending = _pending.find(p_from);
	const bool again =
			pending != nullptr && pending->start.client == start.client && pending->start.share == start.share;
	if (!again) {
		if (!_starts.admit(network_of(p_from), p_now_usec) || !_starts_of_all.admit({}, p_now_usec)) {
			_counts.handshakes_dropped++;
			return;
		}
		// Whoever begins anew has begun before: what was charged then stays charged.
		const bool is_free = !is_locked(start.role) || _return_tags.take(start.return_tag, start.role, p_now_usec);
		PasswordTries::Try charged;
		if (!is_free && !_password_tries.take(p_from, p_now_usec, charged)) {
			_counts.handshakes_later++;
			_pending.remove(p_from);
			refuse(p_from, start.client, Notice::LATER, r_sink);
			return;
		}
		pending = &_pending.add(p_from);
		pending->is_try = !is_free;
		pending->charged = charged;
		if (!begin(*pending, start, p_now_usec)) {
			_pending.remove(p_from);
			return;
		}
	}
	_counts.handshakes++;
	messages::Reply reply;
	reply.client = start.client;
	reply.share = pending->share;
	r_sink.to_outer(p_from, reply.encode());
}

bool ServerHandshake::begin(Pending &r_pending, const messages::Start &p_start, int64_t p_now_usec) {
	r_pending.start = p_start;
	r_pending.since_usec = p_now_usec;
	const Bytes channel = messages::channel_identifier();
	const Bytes session = messages::session_identifier(p_start.client, p_start.cookie);
	r_pending.scalar = cpace::sample_scalar();
	const auto generator = cpace::generator({ _passwords[p_start.role], channel, session });
	const auto share = cpace::share_of(r_pending.scalar, generator);
	r_pending.share = share.value_or(cpace::Share{});
	return share.has_value();
}

const Pending *ServerHandshake::take_first(
		const Endpoint &p_from, const View &p_bytes, RelaySink &r_sink, Bytes &r_opened) {
	Pending *pending = _pending.find(p_from);
	if (pending == nullptr || pending->start.client != read_array<8>(p_bytes.data + 1)) {
		_counts.stray++;
		return nullptr;
	}
	if (!open(*pending, p_bytes, r_opened)) {
		fail(*pending, r_sink);
		return nullptr;
	}
	_counts.opened++;
	return pending;
}

bool ServerHandshake::open(Pending &r_pending, const View &p_bytes, Bytes &r_opened) {
	if (!r_pending.keys) {
		const messages::Start &start = r_pending.start;
		const Bytes session = messages::session_identifier(start.client, start.cookie);
		const Bytes associated = start.associated();
		const auto key = cpace::session_key(
				r_pending.scalar, start.share, session, { start.share, associated }, { r_pending.share, View() });
		if (!key) {
			return false;
		}
		r_pending.keys = ChannelKeys::derive(*key);
		r_pending.channel = SealedChannel(r_pending.keys->to_client, r_pending.keys->to_server);
	}
	return r_pending.channel.open(p_bytes, messages::FIRST_HEAD, r_opened);
}

/// A key exchange is one guess, however often its key turns out to be wrong; and somebody else may have
/// forged this datagram, so that the right one may still come.
void ServerHandshake::fail(Pending &r_pending, RelaySink &r_sink) {
	_counts.not_opened++;
	if (r_pending.has_failed) {
		return;
	}
	r_pending.has_failed = true;
	if (is_locked(r_pending.start.role)) {
		_counts.wrong_passwords++;
		refuse(r_pending.from, r_pending.start.client, Notice::WRONG_PASSWORD, r_sink);
	}
}

void ServerHandshake::finish(const Endpoint &p_from) {
	const Pending *pending = _pending.find(p_from);
	if (pending != nullptr && pending->is_try) {
		_password_tries.give_back(p_from, pending->charged);
	}
	_pending.remove(p_from);
}

void ServerHandshake::take_stranger(
		const Endpoint &p_from, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink) {
	if (!_strangers.admit(network_of(p_from), p_now_usec) || !_all_strangers.admit({}, p_now_usec)) {
		return;
	}
	messages::UnknownMessage answer;
	answer.echo = messages::echo_of(p_bytes);
	answer.cookie = _cookies.make(p_from, p_now_usec);
	r_sink.to_outer(p_from, answer.encode());
}

void ServerHandshake::refuse(
		const Endpoint &p_to, const messages::ClientId &p_client, Notice p_what, RelaySink &r_sink) {
	messages::NoticeMessage notice;
	notice.client = p_client;
	notice.what = p_what;
	notice.version = _version;
	_last_refusal.from = p_to;
	_last_refusal.what = p_what;
	_last_refusal.number++;
	r_sink.to_outer(p_to, notice.encode());
}

void ServerHandshake::note_connected(uint8_t p_role, const messages::ReturnTag &p_tag) {
	if (is_locked(p_role)) {
		_return_tags.add(p_tag, p_role);
	}
}

void ServerHandshake::look_after(int64_t p_now_usec) {
	_pending.look_after(p_now_usec);
	_return_tags.look_after(p_now_usec);
}

} // namespace transport
