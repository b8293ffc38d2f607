// SPDX-License-Identifier: MIT
#include "client_relay.hpp"

#include "enet_reader.hpp"

#include <algorithm>
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
/// How long to wait where the server says "later", us; about, so that not all come at once.
constexpr uint32_t LATER_USEC = 300000;
/// Cookies and replies that are tried in one handshake: all but one are forged.
constexpr size_t MAX_EXCHANGES = 4;
constexpr size_t MAX_CANDIDATES = 8;
/// How long a cookie is tried before the next one, where several have come, us.
constexpr int64_t TURN_USEC = 250000;
/// START is sent again beside the proof so seldom: the reply that has come may be forged, us.
constexpr int64_t AGAIN_USEC = 200000;

} // namespace

ClientRelay::ClientRelay(Settings p_settings, Send p_to_outer, Send p_to_inner, Send p_to_program) :
		_settings(std::move(p_settings)),
		_to_outer(std::move(p_to_outer)),
		_to_inner(std::move(p_to_inner)),
		_to_program(std::move(p_to_program)),
		_send_content([this](Content p_content, const View &p_bytes) { send_content(p_content, p_bytes); }),
		_carriage(_settings.seals ? SealedChannel::OVERHEAD : 1) {
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
		_patience.forget_hint();
		_heard_usec = p_now_usec;
		if (p_bytes.data[0] == messages::OPEN_FAST) {
			_bytes.assign(p_bytes.data + 1, p_bytes.data + p_bytes.size);
			take_content(Content::FAST, p_bytes.size, p_now_usec);
		} else {
			_to_inner(p_bytes);
		}
		return;
	}
	switch (p_bytes.data[0]) {
		case messages::COOKIE:
			take_cookie(p_bytes, p_now_usec);
			break;
		case messages::REPLY:
			take_reply(p_bytes, p_now_usec);
			break;
		case messages::UNKNOWN:
			take_unknown(p_bytes, p_now_usec);
			break;
		default:
			take_sealed(p_bytes, p_now_usec);
	}
}

void ClientRelay::take_inner(const View &p_bytes) {
	if (_settings.seals) {
		if (_step == Step::DONE) {
			_carriage.send(Content::ENET, p_bytes, _send_content);
		} else if (_state == State::OPEN) {
			_last_inner.assign(p_bytes.data, p_bytes.data + p_bytes.size);
			for (Candidate &candidate : _candidates) {
				seal_first(candidate, p_bytes);
			}
		}
		return;
	}
	EnetReader reader(p_bytes);
	EnetCommand command;
	if (reader.peer() == EnetReader::NO_PEER && reader.next(command) && command.kind == EnetCommand::CONNECT) {
		_chosen = command.chosen;
	}
	_carriage.send(Content::ENET, p_bytes, _send_content);
}

void ClientRelay::send_fast(const View &p_bytes) {
	if (_step == Step::DONE) {
		_carriage.send(Content::FAST, p_bytes, _send_content);
	}
}

int64_t ClientRelay::look_after(int64_t p_now_usec) {
	if (_state == State::FAILED) {
		return INT64_MAX;
	}
	if (_step == Step::DONE) {
		// Without sealing there is somebody to answer once he has said something.
		if (_heard_usec == 0) {
			return INT64_MAX;
		}
		_carriage.look_after(p_now_usec, _send_content);
		if (!_settings.seals) {
			return _carriage.mtu().due_usec();
		}
		if (_address.must_ask(_heard_usec, p_now_usec)) {
			send_content(Content::FAST, View());
		}
		return std::min(_carriage.mtu().due_usec(), _address.due_usec(_heard_usec));
	}
	if (!_patience.has_begun() || _patience.is_over(p_now_usec)) {
		if (_patience.is_hopeless(_notice == OTHER_KEY, _settings.return_tag != messages::ReturnTag{})) {
			_state = State::FAILED;
			return INT64_MAX;
		}
		restart(p_now_usec);
	}
	if (_exchanges.size() > 1 && p_now_usec - _turn_usec > TURN_USEC) {
		_turn_usec = p_now_usec;
		_current = (_current + 1) % _exchanges.size();
		_due_usec = p_now_usec;
	}
	if (p_now_usec >= _due_usec) {
		send_due(p_now_usec);
		_due_usec = p_now_usec + (_step == Step::WANTS_COOKIE ? PAUSE_USEC : SHORT_PAUSE_USEC);
	}
	return _due_usec;
}

void ClientRelay::restart(int64_t p_now_usec) {
	randombytes_buf(_client.data(), _client.size());
	_exchanges.clear();
	_candidates.clear();
	_current = 0;
	_state = State::OPENING;
	_patience.begin(p_now_usec);
	_started_usec = 0;
	go_on(Step::WANTS_COOKIE, p_now_usec);
}

void ClientRelay::go_on(Step p_step, int64_t p_now_usec) {
	_step = p_step;
	_patience.begin_step(p_now_usec);
	_turn_usec = p_now_usec;
	_due_usec = p_now_usec;
}

void ClientRelay::send_due(int64_t p_now_usec) {
	if (_step == Step::WANTS_COOKIE) {
		messages::Init init;
		init.version = _settings.version;
		init.role = _settings.role;
		init.client = _client;
		_to_outer(init.encode());
		return;
	}
	const Exchange &current = _exchanges[_current];
	if (!current.is_answered || p_now_usec - _started_usec > AGAIN_USEC) {
		_started_usec = p_now_usec;
		_to_outer(current.start.encode());
	}
	for (Candidate &candidate : _candidates) {
		// Empty: it says only that we have the key.
		seal_first(candidate, View());
	}
}

void ClientRelay::take_cookie(const View &p_bytes, int64_t p_now_usec) {
	messages::CookieReply reply;
	if (_step == Step::DONE || _exchanges.size() >= MAX_EXCHANGES || !reply.decode(p_bytes) ||
			reply.client != _client) {
		return;
	}
	const auto has_cookie = [&reply](const Exchange &p_exchange) { return p_exchange.start.cookie == reply.cookie; };
	if (std::any_of(_exchanges.begin(), _exchanges.end(), has_cookie)) {
		return;
	}
	Exchange exchange;
	exchange.start.version = _settings.version;
	exchange.start.role = _settings.role;
	exchange.start.return_tag = _settings.return_tag;
	exchange.start.client = _client;
	exchange.start.cookie = reply.cookie;
	// A password that was given must be proved: the cookie is anybody's.
	if (!reply.locked && !_settings.password.empty()) {
		hint(ASKS_FOR_NO_PASSWORD, p_now_usec);
	}
	const Bytes channel = messages::channel_identifier();
	const Bytes session = messages::session_identifier(_client, reply.cookie);
	exchange.scalar = cpace::sample_scalar();
	const auto share = cpace::share_of(exchange.scalar, cpace::generator({ _settings.password, channel, session }));
	if (!share) {
		return;
	}
	exchange.start.share = *share;
	_exchanges.push_back(exchange);
	if (_step == Step::WANTS_COOKIE) {
		go_on(Step::WANTS_REPLY, p_now_usec);
		look_after(p_now_usec);
	}
}

void ClientRelay::take_reply(const View &p_bytes, int64_t p_now_usec) {
	messages::Reply reply;
	if (_step == Step::DONE || _exchanges.empty() || !reply.decode(p_bytes) || reply.client != _client) {
		return;
	}
	const auto has_share = [&reply](const Candidate &p_candidate) { return p_candidate.share == reply.share; };
	if (std::any_of(_candidates.begin(), _candidates.end(), has_share) ||
			(!_settings.password.empty() && !_answers.take(p_now_usec))) {
		return;
	}
	Exchange &current = _exchanges[_current];
	const messages::Start &start = current.start;
	const Bytes session = messages::session_identifier(_client, start.cookie);
	const Bytes associated = start.associated();
	const auto key = cpace::session_key(
			current.scalar, reply.share, session, { start.share, associated }, { reply.share, View() });
	if (!key) {
		return;
	}
	if (_candidates.size() >= MAX_CANDIDATES) {
		_candidates.erase(_candidates.begin() + randombytes_uniform(MAX_CANDIDATES));
	}
	current.is_answered = true;
	Candidate candidate;
	candidate.share = reply.share;
	candidate.keys = ChannelKeys::derive(*key);
	candidate.channel = SealedChannel(candidate.keys.to_server, candidate.keys.to_client);
	_candidates.push_back(candidate);
	_state = State::OPEN;
	if (!_last_inner.empty()) {
		seal_first(_candidates.back(), _last_inner);
	}
	if (_step == Step::WANTS_REPLY) {
		go_on(Step::WANTS_PROOF, p_now_usec);
		look_after(p_now_usec);
	} else {
		seal_first(_candidates.back(), View());
	}
}

void ClientRelay::take_sealed(const View &p_bytes, int64_t p_now_usec) {
	Content content = Content::ENET;
	if (_step != Step::DONE) {
		if (!find_proven(p_bytes, p_now_usec)) {
			_not_opened++;
		}
		return;
	}
	if (!_channel.open(p_bytes, content, _bytes)) {
		_not_opened++;
		return;
	}
	_heard_usec = p_now_usec;
	take_content(content, p_bytes.size, p_now_usec);
}

/// The first thing that counts is a server's proof of who it is: whether this is one.
bool ClientRelay::find_proven(const View &p_bytes, int64_t p_now_usec) {
	Content content = Content::ENET;
	const auto opens = [&](Candidate &r_candidate) { return r_candidate.channel.open(p_bytes, content, _bytes); };
	const auto candidate = std::find_if(_candidates.begin(), _candidates.end(), opens);
	ServerIdentity::Proof proof;
	if (candidate == _candidates.end() || content != Content::FAST || _bytes.empty() ||
			_bytes[0] != Carriage::IDENTITY || !proof.decode(View(_bytes).from(1)) ||
			!proof.is_of(candidate->keys.exporter)) {
		return false;
	}
	_server_key = proof.key;
	if (_settings.password.empty() && _settings.known_key && *_settings.known_key != proof.key) {
		hint(OTHER_KEY, p_now_usec);
		return true;
	}
	_keys = candidate->keys;
	_channel = candidate->channel;
	_candidates.clear();
	_exchanges.clear();
	_step = Step::DONE;
	_notice = 0;
	_heard_usec = p_now_usec;
	_carriage.restart(p_now_usec);
	_last_inner.clear();
	return true;
}

/// What the server has sent is in _bytes.
void ClientRelay::take_content(Content p_content, size_t p_size, int64_t p_now_usec) {
	if (_carriage.take(p_content, _bytes, p_size, p_now_usec, _send_content)) {
		(p_content == Content::ENET ? _to_inner : _to_program)(_bytes);
	}
}

/// The server knows nobody at the address from which it has had something of ours: the address is another
/// one than before. Where somebody else says so, nothing comes of it.
void ClientRelay::take_unknown(const View &p_bytes, int64_t p_now_usec) {
	messages::UnknownMessage unknown;
	if (_step != Step::DONE || !unknown.decode(p_bytes) || !_address.has_moved(unknown, _heard_usec, p_now_usec)) {
		return;
	}
	_channel.seal(messages::moved_head(_client, unknown.cookie), View(), _sealed);
	_to_outer(_sealed);
}

void ClientRelay::take_notice(const View &p_bytes, int64_t p_now_usec) {
	messages::NoticeMessage notice;
	const messages::ClientId &own = _settings.seals ? _client : _chosen;
	// Who has opened something of the server's knows better.
	if (!notice.decode(p_bytes) || notice.client != own || (_settings.seals && _step == Step::DONE)) {
		return;
	}
	_server_version = notice.version;
	if (notice.what != Notice::LATER) {
		hint(int(notice.what), p_now_usec);
	} else {
		_notice = int(Notice::LATER);
		if (_step == Step::WANTS_REPLY) {
			_patience.begin_step(p_now_usec);
			// From the last START on: many notices put it off no longer than one does.
			_due_usec = std::max(_due_usec, _started_usec + LATER_USEC / 2 + randombytes_uniform(LATER_USEC));
			_due_usec = std::min(_due_usec, _started_usec + LATER_USEC * 3 / 2);
		}
	}
}

/// Why the handshake comes to nothing, as somebody says.
void ClientRelay::hint(int p_what, int64_t p_now_usec) {
	_notice = p_what;
	_patience.hint(p_now_usec);
	if (!_settings.seals && _patience.is_refused(p_now_usec)) {
		_state = State::FAILED;
	}
}

void ClientRelay::send_content(Content p_content, const View &p_bytes) {
	if (_settings.seals) {
		_channel.seal(p_content, p_bytes, _sealed);
		_address.note_sent(_sealed);
	} else if (p_content == Content::FAST) {
		_sealed = { messages::OPEN_FAST };
		append(_sealed, p_bytes);
	} else {
		_to_outer(p_bytes);
		return;
	}
	_to_outer(_sealed);
}

void ClientRelay::seal_first(Candidate &r_candidate, const View &p_bytes) {
	r_candidate.channel.seal(messages::first_head(_client), p_bytes, _sealed);
	_to_outer(_sealed);
}

} // namespace transport
