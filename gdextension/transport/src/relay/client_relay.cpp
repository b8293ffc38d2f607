// SPDX-License-Identifier: MIT
#include "client_relay.hpp"

#include "enet_reader.hpp"

#include <cstdlib>
#include <sodium.h>
#include <utility>

namespace transport {

namespace {

using messages::Notice;

/// When something is said again, us.
constexpr int64_t PAUSE_USEC = 35000;
/// The same once the server has answered: it chooses by chance among many, so that more tries get in
/// sooner.
constexpr int64_t SHORT_PAUSE_USEC = 20000;
/// A step that takes longer begins anew from the first one: a cookie may have run out, a server may
/// have begun anew, us.
constexpr int64_t MAX_STEP_USEC = 2000000;
/// How long to wait where the server says "later", us; about, so that not all come at once.
constexpr uint32_t LATER_USEC = 300000;

} // namespace

ClientRelay::ClientRelay(Settings p_settings, Send p_to_outer, Send p_to_inner) :
		_settings(std::move(p_settings)), _to_outer(std::move(p_to_outer)), _to_inner(std::move(p_to_inner)) {
	if (sodium_init() < 0) {
		std::abort();
	}
	if (!_settings.seals) {
		_state = State::OPEN;
		_step = Step::DONE;
	}
}

void ClientRelay::take_outer(const View &p_bytes, int64_t p_now_usec) {
	if (p_bytes.size == 0 || _state == State::FAILED) {
		return;
	}
	if (p_bytes.data[0] == messages::NOTICE) {
		take_notice(p_bytes, p_now_usec);
		return;
	}
	if (!_settings.seals) {
		_to_inner(p_bytes);
		return;
	}
	switch (p_bytes.data[0]) {
		case messages::COOKIE:
			take_cookie(p_bytes, p_now_usec);
			break;
		case messages::REPLY:
			take_reply(p_bytes, p_now_usec);
			break;
		case messages::DATA:
			take_data(p_bytes);
			break;
		default:
			_not_opened++;
	}
}

void ClientRelay::take_inner(const View &p_bytes) {
	if (_settings.seals) {
		if (_state == State::OPEN) {
			seal_out(p_bytes);
		}
		return;
	}
	EnetReader reader(p_bytes);
	EnetCommand command;
	if (reader.peer() == EnetReader::NO_PEER && reader.next(command) && command.kind == EnetCommand::CONNECT) {
		_chosen = command.chosen;
	}
	_to_outer(p_bytes);
}

int64_t ClientRelay::look_after(int64_t p_now_usec) {
	if (_step == Step::DONE || _state == State::FAILED) {
		return INT64_MAX;
	}
	if (_step_usec == 0 || p_now_usec - _step_usec > MAX_STEP_USEC) {
		restart(p_now_usec);
	}
	if (p_now_usec >= _due_usec) {
		send_due();
		_due_usec = p_now_usec + (_step == Step::WANTS_COOKIE ? PAUSE_USEC : SHORT_PAUSE_USEC);
	}
	return _due_usec;
}

void ClientRelay::restart(int64_t p_now_usec) {
	_start = messages::Start();
	_start.version = _settings.version;
	_start.role = _settings.role;
	_start.return_tag = _settings.return_tag;
	randombytes_buf(_start.client.data(), _start.client.size());
	_state = State::OPENING;
	go_on(Step::WANTS_COOKIE, p_now_usec);
}

void ClientRelay::go_on(Step p_step, int64_t p_now_usec) {
	_step = p_step;
	_step_usec = p_now_usec;
	_due_usec = p_now_usec;
}

void ClientRelay::send_due() {
	if (_step == Step::WANTS_COOKIE) {
		messages::Init init;
		init.version = _start.version;
		init.role = _start.role;
		init.client = _start.client;
		_to_outer(init.encode());
	} else if (_step == Step::WANTS_REPLY) {
		_to_outer(_start.encode());
	} else if (_step == Step::WANTS_PROOF) {
		// Empty: it says only that we have the key.
		seal_out(View());
	}
}

void ClientRelay::take_cookie(const View &p_bytes, int64_t p_now_usec) {
	messages::CookieReply reply;
	if (_step != Step::WANTS_COOKIE || !reply.decode(p_bytes) || reply.client != _start.client) {
		return;
	}
	_locked = reply.locked;
	_start.cookie = reply.cookie;
	const Bytes channel = messages::channel_identifier();
	const Bytes session = messages::session_identifier(_start.client, _start.cookie);
	const View password = _locked ? View(_settings.password) : View();
	_scalar = cpace::sample_scalar();
	const auto share = cpace::share_of(_scalar, cpace::generator({ password, channel, session }));
	if (!share) {
		return;
	}
	_start.share = *share;
	go_on(Step::WANTS_REPLY, p_now_usec);
	look_after(p_now_usec);
}

void ClientRelay::take_reply(const View &p_bytes, int64_t p_now_usec) {
	messages::Reply reply;
	if (_step != Step::WANTS_REPLY || !reply.decode(p_bytes) || reply.client != _start.client) {
		return;
	}
	const Bytes session = messages::session_identifier(_start.client, _start.cookie);
	const Bytes associated = _start.associated();
	const auto key =
			cpace::session_key(_scalar, reply.share, session, { _start.share, associated }, { reply.share, View() });
	if (!key) {
		return;
	}
	_keys = ChannelKeys::derive(*key);
	_channel = SealedChannel(_keys.to_server, _keys.to_client);
	_state = State::OPEN;
	go_on(Step::WANTS_PROOF, p_now_usec);
	look_after(p_now_usec);
}

void ClientRelay::take_data(const View &p_bytes) {
	if (_state != State::OPEN || !_channel.open(p_bytes, messages::DATA_HEAD, _bytes)) {
		_not_opened++;
		return;
	}
	_step = Step::DONE;
	_notice = 0;
	if (!_bytes.empty()) {
		_to_inner(_bytes);
	}
}

void ClientRelay::take_notice(const View &p_bytes, int64_t p_now_usec) {
	messages::NoticeMessage notice;
	const messages::ClientId &own = _settings.seals ? _start.client : _chosen;
	// Who has opened something of the server's knows better.
	if (!notice.decode(p_bytes) || notice.client != own || (_settings.seals && _step == Step::DONE)) {
		return;
	}
	_notice = int(notice.what);
	_server_version = notice.version;
	if (notice.what == Notice::LATER) {
		if (_step == Step::WANTS_REPLY) {
			_step_usec = p_now_usec;
			_due_usec = p_now_usec + LATER_USEC / 2 + randombytes_uniform(LATER_USEC);
		}
	} else {
		_state = State::FAILED;
	}
}

void ClientRelay::seal_out(const View &p_bytes) {
	static const Bytes data_head{ messages::DATA };
	_channel.seal(_step == Step::DONE ? data_head : messages::first_head(_start.client), p_bytes, _bytes);
	_to_outer(_bytes);
}

} // namespace transport
