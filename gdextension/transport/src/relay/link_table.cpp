// SPDX-License-Identifier: MIT
#include "link_table.hpp"

namespace transport {

namespace {

/// 127.1.0.1 and the addresses behind it stand for clients.
constexpr uint32_t FIRST_INNER = 0x7F010001;
constexpr uint32_t INNER_COUNT = 0x7FFFFFFE - FIRST_INNER;

} // namespace

Link *LinkTable::find(const Endpoint &p_outer) {
	const auto found = _by_outer.find(p_outer);
	return found != _by_outer.end() ? &*found->second : nullptr;
}

Link *LinkTable::find_inner(uint32_t p_inner) {
	const auto found = _by_inner.find(p_inner);
	return found != _by_inner.end() ? &*found->second : nullptr;
}

Link *LinkTable::find_client(const messages::ClientId &p_client) {
	const auto found = _by_client.find(p_client);
	return found != _by_client.end() ? find_inner(found->second) : nullptr;
}

Link *LinkTable::find_peer(int64_t p_peer) {
	const auto found = _by_peer.find(p_peer);
	return found != _by_peer.end() ? find_inner(found->second) : nullptr;
}

void LinkTable::set_client(Link &r_link, const messages::ClientId &p_client) {
	r_link.client = p_client;
	const Link *before = find_client(p_client);
	// Whoever is connected keeps it: others may have seen it.
	if (before == nullptr || !before->is_confirmed) {
		_by_client[p_client] = r_link.inner;
	}
}

void LinkTable::set_peer(Link &r_link, int64_t p_peer) {
	Link *before = find_peer(p_peer);
	if (before != nullptr) {
		before->peer = 0;
	}
	_by_peer.erase(r_link.peer);
	r_link.peer = p_peer;
	_by_peer[p_peer] = r_link.inner;
}

void LinkTable::move(Link &r_link, const Endpoint &p_outer) {
	const Place place = _by_inner[r_link.inner];
	_by_outer.erase(r_link.outer);
	r_link.outer = p_outer;
	_by_outer[p_outer] = place;
}

Link *LinkTable::add(const Endpoint &p_outer, const EnetLimits &p_limits) {
	if (_confirmed.size() >= _max_confirmed || _half_open.size() >= MAX_HALF_OPEN || _by_outer.count(p_outer) > 0) {
		return nullptr;
	}
	_half_open.emplace_back(p_limits, _held);
	Link &link = _half_open.back();
	link.outer = p_outer;
	do {
		link.inner = FIRST_INNER + _next_inner;
		_next_inner = (_next_inner + 1) % INNER_COUNT;
	} while (_by_inner.count(link.inner) > 0);
	const Place place = std::prev(_half_open.end());
	_by_outer[p_outer] = place;
	_by_inner[link.inner] = place;
	return &link;
}

void LinkTable::remove(const Link &p_link) {
	const Place place = _by_inner[p_link.inner];
	std::list<Link> &list = p_link.is_confirmed ? _confirmed : _half_open;
	_by_inner.erase(p_link.inner);
	_by_outer.erase(p_link.outer);
	// Another one may have the same by now.
	const auto client = _by_client.find(p_link.client);
	if (client != _by_client.end() && client->second == p_link.inner) {
		_by_client.erase(client);
	}
	const auto peer = _by_peer.find(p_link.peer);
	if (peer != _by_peer.end() && peer->second == p_link.inner) {
		_by_peer.erase(peer);
	}
	list.erase(place);
}

void LinkTable::confirm(Link &r_link, bool p_confirmed) {
	if (r_link.is_confirmed == p_confirmed) {
		return;
	}
	std::list<Link> &from = p_confirmed ? _half_open : _confirmed;
	std::list<Link> &to = p_confirmed ? _confirmed : _half_open;
	to.splice(to.end(), from, _by_inner[r_link.inner]);
	r_link.is_confirmed = p_confirmed;
}

Link *LinkTable::oldest_half_open() {
	return _half_open.empty() ? nullptr : &_half_open.front();
}

} // namespace transport
