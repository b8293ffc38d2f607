// SPDX-License-Identifier: MIT
#include "server_relay.hpp"

#include <utility>

namespace transport {

namespace {

using messages::Notice;

/// How long a link may be without a connection of ENet's.
constexpr int64_t HALF_OPEN_USEC = 5000000;
/// After so long ENet has given a silent peer up.
constexpr int64_t SILENT_USEC = 8500000;
/// How long a link with a connection may be silent.
constexpr int64_t IDLE_USEC = 15000000;

} // namespace

ServerRelay::ServerRelay(Settings p_settings) :
		_settings(std::move(p_settings)),
		_links(_settings.max_confirmed),
		_handshake(_settings.version, std::move(_settings.passwords), _counts) {}

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
	if (!_settings.seals) {
		take_open(p_from, p_bytes, p_now_usec, r_sink);
		return;
	}
	switch (p_bytes.data[0]) {
		case messages::DATA:
			take_data(p_from, p_bytes, messages::DATA_HEAD, p_now_usec, r_sink);
			break;
		case messages::INIT:
			_handshake.take_init(p_from, p_bytes, p_now_usec, r_sink);
			break;
		case messages::START:
			_handshake.take_start(p_from, p_bytes, p_now_usec, r_sink);
			break;
		case messages::FIRST:
			take_first(p_from, p_bytes, p_now_usec, r_sink);
			break;
		default:
			refuse_open(p_from, p_bytes, r_sink);
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
		// Empty again: what told it that it has the key has been lost.
		if (take_data(p_from, p_bytes, messages::FIRST_HEAD, p_now_usec, r_sink) && _opened.empty()) {
			prove(*link, r_sink);
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

void ServerRelay::establish(const Pending &p_pending, int64_t p_now_usec, RelaySink &r_sink) {
	Link *link = make_link(p_pending.from, p_now_usec, r_sink);
	if (link == nullptr) {
		return;
	}
	link->client = p_pending.start.client;
	link->role = p_pending.start.role;
	link->keys = p_pending.keys.value_or(ChannelKeys());
	link->channel = p_pending.channel;
	prove(*link, r_sink);
}

/// Nothing but this tells a client that it has the key, until ENet answers.
void ServerRelay::prove(Link &r_link, RelaySink &r_sink) {
	r_link.channel.seal(Bytes{ messages::DATA }, View(), _sealed);
	r_sink.to_outer(r_link.outer, _sealed);
}

/// Returns whether it could be opened.
bool ServerRelay::take_data(
		const Endpoint &p_from, const View &p_bytes, size_t p_head, int64_t p_now_usec, RelaySink &r_sink) {
	Link *link = _links.find(p_from);
	if (link == nullptr) {
		_counts.stray++;
		return false;
	}
	if (!link->channel.open(p_bytes, p_head, _opened)) {
		_counts.not_opened++;
		return false;
	}
	_counts.opened++;
	if (!_opened.empty()) {
		hand_in(*link, _opened, p_now_usec, r_sink);
	}
	return true;
}

/// Without sealing: what ENet says goes through as it is.
void ServerRelay::take_open(const Endpoint &p_from, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink) {
	messages::Init init;
	if (init.decode(p_bytes)) {
		_handshake.refuse(p_from, init.client, Notice::SERVER_IS_OPEN, r_sink);
		return;
	}
	Link *link = _links.find(p_from);
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

void ServerRelay::refuse_open(const Endpoint &p_from, const View &p_bytes, RelaySink &r_sink) {
	_counts.stray++;
	EnetReader reader(p_bytes);
	EnetCommand command;
	if (reader.peer() == EnetReader::NO_PEER && reader.next(command) && command.kind == EnetCommand::CONNECT) {
		_handshake.refuse(p_from, command.chosen, Notice::SERVER_SEALS, r_sink);
	}
}

void ServerRelay::hand_in(Link &r_link, const View &p_bytes, int64_t p_now_usec, RelaySink &r_sink) {
	const bool silent = p_now_usec - r_link.heard_usec > SILENT_USEC;
	const EnetGuard::Verdict verdict = r_link.guard.check(p_bytes, silent);
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
	if (!_settings.seals) {
		r_sink.to_outer(link->outer, p_bytes);
		return;
	}
	static const Bytes head{ messages::DATA };
	link->channel.seal(head, p_bytes, _sealed);
	_counts.sealed++;
	r_sink.to_outer(link->outer, _sealed);
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
	std::vector<uint32_t> over;
	_links.for_each([&over, p_now_usec](const Link &p_link) {
		const int64_t since = p_link.is_confirmed ? p_link.heard_usec + IDLE_USEC : p_link.since_usec + HALF_OPEN_USEC;
		if (p_now_usec > since) {
			over.push_back(p_link.inner);
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
