// SPDX-License-Identifier: MIT
#include "server_relay.hpp"

#include <utility>

namespace transport {

namespace {

using messages::Notice;

/// How long a link may be without a connection of ENet's.
constexpr int64_t HALF_OPEN_USEC = 5000000;
/// How long a link with a connection may be silent: its client says something every 1.5 s.
constexpr int64_t SILENT_USEC = 5500000;
/// Where this server has stood still for longer, its clients may have been loud meanwhile.
constexpr int64_t STOOD_STILL_USEC = 1000000;

} // namespace

ServerRelay::ServerRelay(Settings p_settings) :
		_settings(std::move(p_settings)),
		_links(_settings.max_confirmed),
		_handshake(_settings.version, std::move(_settings.passwords), _counts),
		_answering(_counts) {}

void ServerRelay::take_outer(const Endpoint &p_from, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink) {
	// Nothing can be sent to port 0: the attempt would be an error of ENet's.
	if (p_from.port == 0) {
		_counts.from_port_zero++;
		return;
	}
	if (p_bytes.size == 0) {
		_counts.stray++;
		return;
	}
	if (AnsweringMachine::is_asked(p_bytes)) {
		_answering.take(p_from, p_bytes, p_now_usec, r_sink);
		return;
	}
	if (!_settings.seals) {
		take_open(p_from, p_bytes, p_now_usec, r_sink);
		return;
	}
	switch (p_bytes.data[0]) {
		case messages::INIT:
			_handshake.take_init(p_from, p_bytes, p_now_usec, r_sink);
			break;
		case messages::START:
			_handshake.take_start(p_from, p_bytes, p_now_usec, r_sink);
			break;
		case messages::FIRST:
			take_first(p_from, p_bytes, p_now_usec, r_sink);
			break;
		case messages::MOVED:
			take_moved(p_from, p_bytes, p_now_usec, r_sink);
			break;
		default:
			take_sealed(p_from, p_bytes, p_now_usec, r_sink);
	}
}

void ServerRelay::take_first(const Endpoint &p_from, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink) {
	if (p_bytes.size < messages::FIRST_HEAD) {
		_counts.stray++;
		return;
	}
	const auto client = read_array<8>(p_bytes.data + 1);
	Link *link = _links.find(p_from);
	if (link != nullptr && link->client == client) {
		if (!link->channel.open(p_bytes, messages::FIRST_HEAD, _opened)) {
			_counts.not_opened++;
			return;
		}
		_counts.opened++;
		if (_opened.empty()) {
			// Again: what told it that it has the key has been lost.
			prove(*link, r_sink);
		} else {
			hand_in(*link, _opened, p_now_usec, r_sink);
		}
		return;
	}
	const Pending *done = _handshake.take_first(p_from, p_bytes, r_sink, _opened);
	if (done == nullptr) {
		return;
	}
	establish(*done, p_now_usec, r_sink);
	_handshake.finish(p_from);
	link = _links.find(p_from);
	if (link != nullptr && !_opened.empty()) {
		hand_in(*link, _opened, p_now_usec, r_sink);
	}
}

/// A client goes on from another address. It has shown by the cookie that it receives what is sent there,
/// and by the seal that it is the one: so nobody is sent anything that he does not want, and nobody takes
/// a connection away.
void ServerRelay::take_moved(const Endpoint &p_from, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink) {
	if (p_bytes.size < messages::MOVED_HEAD) {
		_counts.stray++;
		return;
	}
	// Opened first: its number is used up then, so that nobody says it again from elsewhere.
	Link *link = _links.find_client(read_array<8>(p_bytes.data + 1));
	if (link == nullptr || !link->channel.open(p_bytes, messages::MOVED_HEAD, _opened)) {
		_counts.not_opened++;
		return;
	}
	_counts.opened++;
	if (!_handshake.is_at(p_from, read_array<12>(p_bytes.data + 9), p_now_usec)) {
		_counts.bad_cookies++;
		return;
	}
	if (!(link->outer == p_from)) {
		Link *other = _links.find(p_from);
		if (other != nullptr) {
			end(*other, p_now_usec, r_sink);
		}
		_counts.moved++;
		_links.move(*link, p_from);
		link->carriage.restart(p_now_usec);
	}
	link->heard_usec = p_now_usec;
	prove(*link, r_sink);
}

void ServerRelay::take_sealed(const Endpoint &p_from, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink) {
	Link *link = _links.find(p_from);
	if (link == nullptr) {
		_counts.stray++;
		if (!refuse_open(p_from, p_bytes, r_sink) && SealedChannel::is_sealed(p_bytes) && _links.confirmed() > 0) {
			_handshake.take_stranger(p_from, p_bytes, p_now_usec, r_sink);
		}
		return;
	}
	Content content = Content::ENET;
	if (!link->channel.open(p_bytes, content, _opened)) {
		_counts.not_opened++;
		// Somebody else may have had this address a moment ago.
		if (SealedChannel::is_sealed(p_bytes)) {
			_handshake.take_stranger(p_from, p_bytes, p_now_usec, r_sink);
		}
		return;
	}
	_counts.opened++;
	link->heard_usec = p_now_usec;
	take_content(*link, content, p_bytes.size, p_now_usec, r_sink);
}

/// What a client has sent is in _opened.
void ServerRelay::take_content(Link &r_link, Content p_content, size_t p_size, int64_t p_now_usec, RelaySink &r_sink) {
	if (!r_link.carriage.take(p_content, _opened, p_size, p_now_usec, sender(r_link, r_sink))) {
		return;
	}
	if (p_content == Content::ENET) {
		hand_in(r_link, _opened, p_now_usec, r_sink);
	} else if (r_link.peer != 0) {
		r_sink.to_program(r_link.peer, _opened);
	}
}

void ServerRelay::establish(const Pending &p_pending, int64_t p_now_usec, RelaySink &r_sink) {
	Link *link = make_link(p_pending.from, p_now_usec, r_sink);
	if (link == nullptr) {
		return;
	}
	_links.set_client(*link, p_pending.start.client);
	link->role = p_pending.start.role;
	link->keys = p_pending.keys.value_or(ChannelKeys());
	link->channel = p_pending.channel;
	link->identity = { Carriage::IDENTITY };
	append(link->identity, _settings.identity.prove(link->keys.exporter).encode());
	prove(*link, r_sink);
}

/// Tells a client that it has the key, and whose server this is.
void ServerRelay::prove(Link &r_link, RelaySink &r_sink) {
	r_link.channel.seal(Content::FAST, r_link.identity, _sealed);
	r_sink.to_outer(r_link.outer, _sealed);
}

Carriage::Send ServerRelay::sender(Link &r_link, RelaySink &r_sink) {
	return [this, &r_link, &r_sink](Content p_content, const View &p_bytes) {
		if (_settings.seals) {
			r_link.channel.seal(p_content, p_bytes, _sealed);
			_counts.sealed++;
			r_sink.to_outer(r_link.outer, _sealed);
		} else if (p_content == Content::ENET) {
			r_sink.to_outer(r_link.outer, p_bytes);
		} else {
			_sealed = { messages::OPEN_FAST };
			append(_sealed, p_bytes);
			r_sink.to_outer(r_link.outer, _sealed);
		}
	};
}

/// Without sealing: what ENet says goes through as it is.
void ServerRelay::take_open(const Endpoint &p_from, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink) {
	messages::Init init;
	if (init.decode(p_bytes)) {
		_handshake.refuse(p_from, init.client, Notice::SERVER_IS_OPEN, r_sink);
		return;
	}
	Link *link = _links.find(p_from);
	if (p_bytes.data[0] == messages::OPEN_FAST) {
		if (link == nullptr) {
			_counts.stray++;
			return;
		}
		_opened.assign(p_bytes.data + 1, p_bytes.data + p_bytes.size);
		take_content(*link, Content::FAST, p_bytes.size, p_now_usec, r_sink);
		return;
	}
	EnetReader reader(p_bytes);
	EnetCommand command;
	const bool connects =
			reader.peer() == EnetReader::NO_PEER && reader.next(command) && command.kind == EnetCommand::CONNECT;
	if (link == nullptr && !connects) {
		_counts.stray++;
		return;
	}
	// One of ENet's slots for each port, however often a CONNECT comes from there.
	if (link == nullptr || (connects && !link->is_confirmed && link->guard.is_another(command))) {
		link = make_link(p_from, p_now_usec, r_sink);
	}
	if (link != nullptr) {
		hand_in(*link, p_bytes, p_now_usec, r_sink);
	}
}

/// Whether it is somebody who does not seal.
bool ServerRelay::refuse_open(const Endpoint &p_from, const View &p_bytes, RelaySink &r_sink) {
	EnetReader reader(p_bytes);
	EnetCommand command;
	if (reader.peer() != EnetReader::NO_PEER || !reader.next(command) || command.kind != EnetCommand::CONNECT) {
		return false;
	}
	_handshake.refuse(p_from, command.chosen, Notice::SERVER_SEALS, r_sink);
	return true;
}

void ServerRelay::hand_in(Link &r_link, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink) {
	const EnetGuard::Verdict verdict = r_link.guard.check(p_bytes);
	if (verdict != EnetGuard::PASS) {
		count(verdict);
		// Somebody whom ENet will never answer needs no slot.
		if (!_settings.seals && r_link.heard_usec == 0) {
			_links.remove(r_link);
		}
		return;
	}
	r_link.heard_usec = p_now_usec;
	r_sink.to_inner(r_link.inner, p_bytes);
	if (r_link.guard.is_confirmed() && !r_link.is_confirmed) {
		_links.confirm(r_link, true);
		if (_settings.seals) {
			_handshake.note_connected(r_link.role, r_link.keys.return_tag);
		}
	}
}

void ServerRelay::count(EnetGuard::Verdict p_verdict) {
	switch (p_verdict) {
		case EnetGuard::TOO_FEW_CHANNELS:
			_counts.too_few_channels++;
			break;
		case EnetGuard::BAD_FRAGMENT:
			_counts.bad_fragments++;
			break;
		case EnetGuard::HELD_TOO_MUCH:
			_counts.held_too_much++;
			break;
		default:
			_counts.malformed++;
	}
}

Link *ServerRelay::make_link(const Endpoint &p_from, int64_t p_now_usec, RelaySink &r_sink) {
	Link *before = _links.find(p_from);
	if (before != nullptr) {
		end(*before, p_now_usec, r_sink);
	}
	if (_links.is_crowded()) {
		_counts.evicted++;
		end(*_links.oldest_half_open(), p_now_usec, r_sink);
	}
	Link *link = _links.add(p_from, _settings.limits);
	if (link != nullptr) {
		link->since_usec = p_now_usec;
		link->carriage = Carriage(_settings.seals ? SealedChannel::OVERHEAD : 1);
	}
	return link;
}

void ServerRelay::end(Link &r_link, int64_t p_now_usec, RelaySink &r_sink) {
	_handshake.note_gone(r_link.keys.return_tag, p_now_usec);
	if (r_link.guard.has_peer()) {
		r_sink.to_inner(r_link.inner, make_enet_disconnect(r_link.guard.peer(), r_link.guard.session()));
	}
	_links.remove(r_link);
}

void ServerRelay::take_inner(uint32_t p_to, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink) {
	Link *link = _links.find_inner(p_to);
	if (link == nullptr) {
		end_orphan(p_to, p_bytes, r_sink);
		return;
	}
	link->guard.note_sent(p_bytes);
	if (link->is_confirmed && !link->guard.is_confirmed()) {
		link->since_usec = p_now_usec;
		_links.confirm(*link, false);
	}
	link->carriage.send(Content::ENET, p_bytes, sender(*link, r_sink));
}

void ServerRelay::name(uint32_t p_inner, int64_t p_peer) {
	Link *link = _links.find_inner(p_inner);
	if (link != nullptr) {
		_links.set_peer(*link, p_peer);
	}
}

void ServerRelay::send_fast(int64_t p_peer, const View &p_bytes, RelaySink &r_sink) {
	Link *link = _links.find_peer(p_peer);
	if (link != nullptr) {
		link->carriage.send(Content::FAST, p_bytes, sender(*link, r_sink));
	}
}

/// ENet answers a CONNECT of somebody who has made room meanwhile: its slot becomes free.
void ServerRelay::end_orphan(uint32_t p_to, const View &p_bytes, RelaySink &r_sink) {
	EnetReader reader(p_bytes);
	EnetCommand command;
	while (reader.next(command)) {
		if (command.kind == EnetCommand::VERIFY_CONNECT) {
			r_sink.to_inner(p_to, make_enet_disconnect(command.peer, command.outgoing_session));
		}
	}
}

void ServerRelay::look_after(int64_t p_now_usec, RelaySink &r_sink) {
	_handshake.look_after(p_now_usec);
	const int64_t stood_still_usec = _looked_usec > 0 ? p_now_usec - _looked_usec : 0;
	_looked_usec = p_now_usec;
	std::vector<uint32_t> over;
	_links.for_each([&](Link &r_link) {
		if (stood_still_usec > STOOD_STILL_USEC) {
			r_link.heard_usec += stood_still_usec;
		}
		const int64_t since =
				r_link.is_confirmed ? r_link.heard_usec + SILENT_USEC : r_link.since_usec + HALF_OPEN_USEC;
		if (p_now_usec > since) {
			over.push_back(r_link.inner);
		} else if (r_link.is_confirmed && r_link.peer != 0) {
			// ENet knows him: nobody is sent probes that others have asked for in his name.
			r_link.carriage.look_after(p_now_usec, sender(r_link, r_sink));
		}
	});
	for (const uint32_t inner : over) {
		end(*_links.find_inner(inner), p_now_usec, r_sink);
	}
}

bool ServerRelay::find(uint32_t p_inner, Client &r_client) {
	const Link *link = _links.find_inner(p_inner);
	if (link != nullptr) {
		r_client.outer = link->outer;
		r_client.role = link->role;
		r_client.exporter = link->keys.exporter;
	}
	return link != nullptr;
}

void ServerRelay::admit(uint32_t p_inner) {
	Link *link = _links.find_inner(p_inner);
	if (link != nullptr) {
		link->guard.admit();
	}
}

} // namespace transport
