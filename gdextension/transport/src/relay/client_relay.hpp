// SPDX-License-Identifier: MIT
#pragma once

#include "../sealing/messages.hpp"
#include "../sealing/sealed_channel.hpp"

#include <functional>

namespace transport {

/// A client's end between the network and ENet, the counterpart of ServerRelay.
class ClientRelay {
public:
	struct Settings {
		bool seals = true;
		uint32_t version = 0;
		uint8_t role = 0;
		Bytes password;
		messages::ReturnTag return_tag{};
	};

	enum class State {
		/// The handshake goes on.
		OPENING,
		/// ENet may begin.
		OPEN,
		/// It will not get any further: failure() says why.
		FAILED,
	};

	/// Sends a datagram: to the server, or to ENet.
	using Send = std::function<void(const View &)>;

	ClientRelay(Settings p_settings, Send p_to_outer, Send p_to_inner);

	/// A datagram has come from the server.
	void take_outer(const View &p_bytes, int64_t p_now_usec);
	/// ENet has sent a datagram.
	void take_inner(const View &p_bytes);
	/// Sends again what is due. Returns when it must be called again, us; nothing is due without
	/// sealing and once the server has answered.
	int64_t look_after(int64_t p_now_usec);

	State state() const { return _state; }
	/// What the server has said last, 0: nothing.
	int notice() const { return _notice; }
	uint32_t server_version() const { return _server_version; }
	/// Whether the role needs a password, as the server says.
	bool is_locked() const { return _locked; }
	const ChannelKeys &keys() const { return _keys; }
	uint64_t not_opened() const { return _not_opened; }

private:
	enum class Step {
		WANTS_COOKIE,
		WANTS_REPLY,
		WANTS_PROOF,
		DONE
	};

	void restart(int64_t p_now_usec);
	void go_on(Step p_step, int64_t p_now_usec);
	void send_due();
	void take_cookie(const View &p_bytes, int64_t p_now_usec);
	void take_reply(const View &p_bytes, int64_t p_now_usec);
	void take_data(const View &p_bytes);
	void take_notice(const View &p_bytes, int64_t p_now_usec);
	void seal_out(const View &p_bytes);

	Settings _settings;
	Send _to_outer;
	Send _to_inner;
	State _state = State::OPENING;
	Step _step = Step::WANTS_COOKIE;
	messages::Start _start;
	cpace::Scalar _scalar{};
	bool _locked = false;
	ChannelKeys _keys;
	SealedChannel _channel;
	messages::ClientId _chosen{};
	int _notice = 0;
	uint32_t _server_version = 0;
	uint64_t _not_opened = 0;
	int64_t _step_usec = 0;
	int64_t _due_usec = 0;
	Bytes _bytes;
};

} // namespace transport
