// SPDX-License-Identifier: MIT
#pragma once

#include "../sealing/messages.hpp"
#include "../sealing/server_identity.hpp"
#include "address_watch.hpp"
#include "answer_budget.hpp"
#include "carriage.hpp"
#include "handshake_patience.hpp"

#include <functional>
#include <vector>

namespace transport {

/// A client's end between the network and ENet, the counterpart of ServerRelay.
///
/// Nothing is believed before the server has shown that it has the key, which takes the password where
/// there is one: until then cookies, replies and notices may be forged by whoever sees the handshake.
/// So each of them is tried beside the others, none ends the handshake, and a password that was given
/// is used whatever a cookie says.
class ClientRelay {
public:
	struct Settings {
		bool seals = true;
		uint32_t version = 0;
		uint8_t role = 0;
		Bytes password;
		messages::ReturnTag return_tag{};
		/// The server that is meant, if it is known: asked of it where there is no password.
		std::optional<ServerIdentity::PublicKey> known_key;
	};

	enum class State {
		/// The handshake goes on.
		OPENING,
		/// ENet may begin.
		OPEN,
		/// Several handshakes in a row came to nothing, and each time the server said why, or seemed to.
		FAILED,
	};

	/// A notice that no server sends: the cookie says that the role needs no password, and we have one.
	static constexpr int ASKS_FOR_NO_PASSWORD = 6;
	/// Another one: the server has proved another identity than the one that is known.
	static constexpr int OTHER_KEY = 7;

	/// Sends a datagram: to the server, or to ENet.
	using Send = std::function<void(const View &)>;

	/// What goes beside ENet is given to p_to_program.
	ClientRelay(Settings p_settings, Send p_to_outer, Send p_to_inner, Send p_to_program);

	/// A datagram has come from the server.
	void take_outer(const View &p_bytes, int64_t p_now_usec);
	/// ENet has sent a datagram.
	void take_inner(const View &p_bytes);
	/// Sends a message beside ENet; nothing is sent before the channel is open.
	void send_fast(const View &p_bytes);
	/// Sends again what is due. Returns when it must be called again, us.
	int64_t look_after(int64_t p_now_usec);

	State state() const { return _state; }
	/// What the server has said last, 0: nothing. Anybody may have said it.
	int notice() const { return _notice; }
	uint32_t server_version() const { return _server_version; }
	/// Whether the role needs a password: the server has proved it once the channel is open.
	bool is_locked() const { return _step == Step::DONE && !_settings.password.empty(); }
	/// Of the channel, once the server has shown that it has them.
	const ChannelKeys &keys() const { return _keys; }
	/// The server's own, as it has proved; where it is OTHER_KEY, the one that was shown.
	const ServerIdentity::PublicKey &server_key() const { return _server_key; }
	/// When something of the server's was opened last, us; 0: nothing yet.
	int64_t heard_usec() const { return _heard_usec; }
	/// The way to the server is another one.
	void restart_path(int64_t p_now_usec) { _carriage.restart(p_now_usec); }
	/// What is known of the path.
	const PathMtu &mtu() const { return _carriage.mtu(); }
	uint64_t not_opened() const { return _not_opened; }

private:
	enum class Step {
		WANTS_COOKIE,
		WANTS_REPLY,
		WANTS_PROOF,
		DONE
	};

	/// A key exchange for one of the cookies that have come.
	struct Exchange {
		messages::Start start;
		cpace::Scalar scalar{};
		/// Whether a reply has come for it.
		bool is_answered = false;
	};

	/// A channel for one of the replies that have come.
	struct Candidate {
		cpace::Share share{};
		ChannelKeys keys;
		SealedChannel channel;
	};

	void restart(int64_t p_now_usec);
	void go_on(Step p_step, int64_t p_now_usec);
	void send_due(int64_t p_now_usec);
	void take_cookie(const View &p_bytes, int64_t p_now_usec);
	void take_reply(const View &p_bytes, int64_t p_now_usec);
	void take_sealed(const View &p_bytes, int64_t p_now_usec);
	bool find_proven(const View &p_bytes, int64_t p_now_usec);
	void take_content(Content p_content, size_t p_size, int64_t p_now_usec);
	void take_unknown(const View &p_bytes, int64_t p_now_usec);
	void take_notice(const View &p_bytes, int64_t p_now_usec);
	void hint(int p_what, int64_t p_now_usec);
	void send_content(Content p_content, const View &p_bytes);
	void seal_first(Candidate &r_candidate, const View &p_bytes);

	Settings _settings;
	Send _to_outer;
	Send _to_inner;
	Send _to_program;
	Carriage::Send _send_content;
	State _state = State::OPENING;
	Step _step = Step::WANTS_COOKIE;
	messages::ClientId _client{};
	std::vector<Exchange> _exchanges;
	/// The one whose START is sent: the others follow where it comes to nothing.
	size_t _current = 0;
	std::vector<Candidate> _candidates;
	ChannelKeys _keys;
	SealedChannel _channel;
	Carriage _carriage;
	ServerIdentity::PublicKey _server_key{};
	messages::ClientId _chosen{};
	int _notice = 0;
	uint32_t _server_version = 0;
	HandshakePatience _patience;
	/// With a password: replies that may be answered.
	AnswerBudget _answers;
	AddressWatch _address;
	uint64_t _not_opened = 0;
	int64_t _turn_usec = 0;
	int64_t _started_usec = 0;
	int64_t _due_usec = 0;
	int64_t _heard_usec = 0;
	/// What ENet has sent last before the channel was open.
	Bytes _last_inner;
	Bytes _bytes;
	Bytes _sealed;
};

} // namespace transport
