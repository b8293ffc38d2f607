// SPDX-License-Identifier: MIT
#include "sealed_socket.hpp"

#include "../src/clock.hpp"
#include "../src/socket_wait.hpp"

#include <algorithm>

namespace godot {

namespace {

/// The loopback address that stands for a client's server.
constexpr uint32_t SERVER_INNER = 0x7F000001;
/// The number by which a client knows its server.
constexpr int64_t SERVER_PEER = 1;
/// After so much silence, and then so often, a client looks whether its network is another one, us.
constexpr int64_t SILENT_USEC = 250000;
/// Datagrams that are read before ENet is served: all that ENet's socket holds, and no more.
constexpr size_t READ_AT_ONCE = 64;
constexpr size_t MAX_HANDED_IN = 128;
/// After so long ENet is served in any case, us.
constexpr int64_t MAX_READING_USEC = 2000;
constexpr int64_t LOOK_USEC = 200000;

transport::Bytes utf8(const String &p_text) {
	const CharString text = p_text.utf8();
	const auto *begin = reinterpret_cast<const uint8_t *>(text.get_data());
	return transport::Bytes(begin, begin + text.length());
}

template <typename Array>
PackedByteArray packed(const Array &p_bytes) {
	PackedByteArray made;
	made.resize(int64_t(p_bytes.size()));
	std::copy(p_bytes.begin(), p_bytes.end(), made.ptrw());
	return made;
}

/// The reverse of packed(); false if there are more or fewer bytes.
template <typename Array>
bool unpack(const PackedByteArray &p_bytes, Array &r_bytes) {
	if (size_t(p_bytes.size()) != r_bytes.size()) {
		return false;
	}
	std::copy_n(p_bytes.ptr(), r_bytes.size(), r_bytes.begin());
	return true;
}

/// An IPv4 address as a number; false if it is none.
bool parse_inner(const String &p_address, uint32_t &r_number) {
	transport::Endpoint inner;
	if (!inner.parse(p_address.utf8().get_data(), 0)) {
		return false;
	}
	r_number = 0;
	for (size_t i = 12; i < 16; i++) {
		r_number = r_number << 8 | inner.address[i];
	}
	return true;
}

} // namespace

void SealedSocket::set_sealing(bool p_seals, int64_t p_version) {
	_settings.seals = _client_settings.seals = p_seals;
	_settings.version = _client_settings.version = uint32_t(p_version);
}

void SealedSocket::set_passwords(const PackedStringArray &p_of_roles) {
	ERR_FAIL_COND_MSG(p_of_roles.size() > transport::messages::ROLES, "There are fewer roles than passwords.");
	for (int64_t i = 0; i < p_of_roles.size(); i++) {
		_settings.passwords[size_t(i)] = utf8(p_of_roles[i]);
	}
	if (_server) {
		_server->set_passwords(_settings.passwords);
	}
}

void SealedSocket::set_client(int64_t p_role, const String &p_password, const PackedByteArray &p_return_tag) {
	ERR_FAIL_COND_MSG(p_role < 0 || p_role >= transport::messages::ROLES, "There is no such role.");
	_client_settings.role = uint8_t(p_role);
	_client_settings.password = utf8(p_password);
	_client_settings.return_tag = {};
	unpack(p_return_tag, _client_settings.return_tag);
}

void SealedSocket::set_server_key(const PackedByteArray &p_seed) {
	transport::ServerIdentity::Seed seed{};
	const bool has_seed = unpack(p_seed, seed);
	ERR_FAIL_COND_MSG(!has_seed && !p_seed.is_empty(), "A seed has 32 bytes.");
	_settings.identity = has_seed ? transport::ServerIdentity(seed) : transport::ServerIdentity();
}

void SealedSocket::set_known_key(const PackedByteArray &p_key) {
	transport::ServerIdentity::PublicKey key{};
	const bool has_key = unpack(p_key, key);
	ERR_FAIL_COND_MSG(!has_key && !p_key.is_empty(), "A key has 32 bytes.");
	_client_settings.known_key = has_key ? std::make_optional(key) : std::nullopt;
}

void SealedSocket::set_limits(int64_t p_max_packet, int64_t p_min_channels, int64_t p_slots) {
	ERR_FAIL_COND_MSG(p_slots <= int64_t(transport::LinkTable::MAX_HALF_OPEN), "There are too few slots.");
	_settings.limits.bounded = p_max_packet > 0;
	_settings.limits.max_packet = uint32_t(p_max_packet);
	_settings.limits.min_channels = uint32_t(p_min_channels);
	_settings.max_confirmed = size_t(p_slots) - transport::LinkTable::MAX_HALF_OPEN - 1;
}

Error SealedSocket::set_announcement(const PackedByteArray &p_body) {
	const transport::View body(p_body.ptr(), size_t(p_body.size()));
	ERR_FAIL_COND_V_MSG(body.size > transport::discovery::MAX_BODY, ERR_INVALID_PARAMETER,
			"An answer is longer than its question.");
	_announcement = transport::Bytes(body.data, body.data + body.size);
	if (_server) {
		_server->set_announcement(_announcement);
	}
	return OK;
}

Error SealedSocket::open_server(const String &p_address, int64_t p_port) {
	ERR_FAIL_COND_V_MSG(_server || _client, ERR_ALREADY_IN_USE, "The socket is open already.");
	ERR_FAIL_COND_V_MSG(p_port < 0 || p_port > 65535, ERR_INVALID_PARAMETER, "There is no such port.");
	const int failure = _socket.open_server(p_address.utf8().get_data(), uint16_t(p_port));
	if (failure == 0) {
		_server = std::make_unique<transport::ServerRelay>(_settings);
		_server->set_announcement(_announcement);
	}
	return failure == 0 ? OK : ERR_CANT_CREATE;
}

Error SealedSocket::open_client(const String &p_address, int64_t p_port) {
	ERR_FAIL_COND_V_MSG(_server || _client, ERR_ALREADY_IN_USE, "The socket is open already.");
	ERR_FAIL_COND_V_MSG(p_port < 1 || p_port > 65535, ERR_INVALID_PARAMETER, "There is no such port.");
	if (!_server_at.parse(p_address.utf8().get_data(), uint16_t(p_port))) {
		return ERR_CANT_RESOLVE;
	}
	const int failure = _socket.open_client(_server_at);
	if (failure == 0) {
		_client = std::make_unique<transport::ClientRelay>(
				_client_settings, [this](const transport::View &p_bytes) { to_outer(_server_at, p_bytes); },
				[this](const transport::View &p_bytes) { to_inner(SERVER_INNER, p_bytes); },
				[this](const transport::View &p_bytes) { to_program(SERVER_PEER, p_bytes); });
	}
	return failure == 0 ? OK : ERR_CANT_CREATE;
}

Error SealedSocket::tie(const Ref<ENetConnection> &p_host) {
	ERR_FAIL_COND_V_MSG(p_host.is_null(), ERR_INVALID_PARAMETER, "A socket is tied to a host: found none.");
	const uint16_t port = uint16_t(p_host->get_local_port());
	const int descriptor = transport::find_udp_socket(port);
	return descriptor >= 0 && _socket.tie(descriptor, port) ? OK : ERR_CANT_CREATE;
}

void SealedSocket::close() {
	_socket.close();
	_server.reset();
	_client.reset();
	_fast.take(0);
}

int64_t SealedSocket::get_port() const {
	return _socket.outer() >= 0 ? _socket.outer_port() : 0;
}

int64_t SealedSocket::get_inner_port() const {
	return _socket.inner_port();
}

SealedSocket::State SealedSocket::get_state() const {
	if (_server) {
		return STATE_OPEN;
	}
	return _client ? State(int(_client->state()) + int(STATE_OPENING)) : STATE_CLOSED;
}

SealedSocket::Notice SealedSocket::get_notice() const {
	return _client ? Notice(_client->notice()) : NOTICE_NONE;
}

int64_t SealedSocket::get_server_version() const {
	return _client ? _client->server_version() : 0;
}

bool SealedSocket::is_locked() const {
	return _client && _client->is_locked();
}

PackedByteArray SealedSocket::get_exporter() const {
	const bool sealed = _client && _client_settings.seals;
	return sealed ? packed(_client->keys().exporter) : PackedByteArray();
}

PackedByteArray SealedSocket::get_return_tag() const {
	const bool sealed = _client && _client_settings.seals;
	return sealed ? packed(_client->keys().return_tag) : PackedByteArray();
}

PackedByteArray SealedSocket::get_server_key() const {
	if (!_client) {
		return packed(_settings.identity.key());
	}
	return _client_settings.seals ? packed(_client->server_key()) : PackedByteArray();
}

int64_t SealedSocket::get_silent_usec() const {
	const int64_t heard_usec = _client ? _client->heard_usec() : 0;
	return heard_usec > 0 ? transport::now_usec() - heard_usec : 0;
}

int64_t SealedSocket::get_max_datagram() const {
	return _client && _client->mtu().is_settled() ? int64_t(_client->mtu().limit()) : 0;
}

Dictionary SealedSocket::describe(const String &p_inner_address) {
	Dictionary made;
	uint32_t number = 0;
	if (!_server || !parse_inner(p_inner_address, number)) {
		return made;
	}
	transport::ServerRelay::Client client;
	if (_server->find(number, client)) {
		made["address"] = String(client.outer.address_text().c_str());
		made["port"] = client.outer.port;
		made["role"] = client.role;
		made["exporter"] = _settings.seals ? packed(client.exporter) : PackedByteArray();
	}
	return made;
}

void SealedSocket::name(const String &p_inner_address, int64_t p_peer) {
	uint32_t number = 0;
	if (_server && parse_inner(p_inner_address, number)) {
		_server->name(number, p_peer);
	}
}

void SealedSocket::send_fast(int64_t p_peer, const PackedByteArray &p_bytes) {
	const transport::View bytes(p_bytes.ptr(), size_t(p_bytes.size()));
	if (_server) {
		_server->send_fast(p_peer, bytes, *this);
	} else if (_client) {
		_client->send_fast(bytes);
	}
}

void SealedSocket::send_fast_each(const PackedInt32Array &p_peers, const TypedArray<PackedByteArray> &p_datagrams) {
	ERR_FAIL_COND_MSG(p_peers.size() != p_datagrams.size(), "Each datagram needs a peer.");
	for (int64_t i = 0; i < p_peers.size(); i++) {
		send_fast(p_peers[i], p_datagrams[i]);
	}
}

void SealedSocket::admit(const String &p_inner_address) {
	uint32_t number = 0;
	if (_server && parse_inner(p_inner_address, number)) {
		_server->admit(number);
	}
}

Dictionary SealedSocket::take_refusal() {
	Dictionary made;
	if (_server && _server->last_refusal().number != _refusals_taken) {
		const transport::ServerHandshake::Refusal &last = _server->last_refusal();
		_refusals_taken = last.number;
		made["address"] = String(last.from.address_text().c_str());
		made["notice"] = int(last.what);
		made["version"] = last.version;
	}
	return made;
}

Dictionary SealedSocket::stats() const {
	Dictionary made = _traffic.describe();
	if (_client) {
		made["not_opened"] = _client->not_opened();
	}
	if (_server) {
		describe_server(*_server, made);
	}
	return made;
}

int64_t SealedSocket::take_in(int64_t p_now_usec) {
	_handed_in = 0;
	const auto take = [this, p_now_usec](const transport::Endpoint &p_from, const transport::View &p_bytes) {
		_traffic.note_received(p_bytes.size);
		if (_server) {
			_server->take_outer(p_from, p_bytes, p_now_usec, *this);
		} else if (_client) {
			_client->take_outer(p_bytes, p_now_usec);
		}
	};
	const int64_t until_usec = transport::now_usec() + MAX_READING_USEC;
	while (_handed_in < MAX_HANDED_IN && _socket.has_room() && transport::now_usec() < until_usec) {
		const size_t read = _socket.read_outer(READ_AT_ONCE, take);
		_socket.flush();
		if (read < READ_AT_ONCE) {
			break;
		}
	}
	int64_t due = p_now_usec + LOOK_USEC;
	if (_client) {
		follow_route(p_now_usec);
		due = std::min(due, _client->look_after(p_now_usec));
	} else if (_server && p_now_usec - _looked_usec > LOOK_USEC) {
		_looked_usec = p_now_usec;
		_server->look_after(p_now_usec, *this);
	}
	_socket.flush();
	return due;
}

/// Whoever hears nothing may be in another network than before.
void SealedSocket::follow_route(int64_t p_now_usec) {
	if (get_silent_usec() > SILENT_USEC && p_now_usec - _looked_usec > SILENT_USEC) {
		_looked_usec = p_now_usec;
		if (_socket.follow_route(_server_at)) {
			_client->restart_path(p_now_usec);
		}
	}
}

void SealedSocket::send_out(int64_t p_now_usec) {
	_socket.read_inner([this, p_now_usec](uint32_t p_to, const transport::View &p_bytes) {
		if (p_bytes.size == 0) {
			return;
		}
		if (_server) {
			_server->take_inner(p_to, p_bytes, p_now_usec, *this);
		} else if (_client) {
			_client->take_inner(p_bytes);
		}
	});
	_socket.flush();
}

void SealedSocket::to_outer(const transport::Endpoint &p_to, const transport::View &p_bytes) {
	_traffic.note_sent(p_bytes.size);
	_socket.write_outer(p_to, p_bytes);
}

void SealedSocket::to_inner(uint32_t p_from, const transport::View &p_bytes) {
	_handed_in++;
	_socket.write_inner(p_from, p_bytes);
}

void SealedSocket::to_program(int64_t p_peer, const transport::View &p_bytes) {
	_fast.put(p_peer, p_bytes);
	_handed_in++;
}

void SealedSocket::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_sealing", "seals", "version"), &SealedSocket::set_sealing);
	ClassDB::bind_method(D_METHOD("set_passwords", "of_roles"), &SealedSocket::set_passwords);
	ClassDB::bind_method(D_METHOD("set_client", "role", "password", "return_tag"), &SealedSocket::set_client);
	ClassDB::bind_method(D_METHOD("set_server_key", "seed"), &SealedSocket::set_server_key);
	ClassDB::bind_method(D_METHOD("set_known_key", "key"), &SealedSocket::set_known_key);
	ClassDB::bind_method(D_METHOD("set_limits", "max_packet", "min_channels", "slots"), &SealedSocket::set_limits);
	ClassDB::bind_method(D_METHOD("set_announcement", "body"), &SealedSocket::set_announcement);
	ClassDB::bind_method(D_METHOD("open_server", "address", "port"), &SealedSocket::open_server);
	ClassDB::bind_method(D_METHOD("open_client", "address", "port"), &SealedSocket::open_client);
	ClassDB::bind_method(D_METHOD("tie", "host"), &SealedSocket::tie);
	ClassDB::bind_method(D_METHOD("close"), &SealedSocket::close);
	ClassDB::bind_method(D_METHOD("get_port"), &SealedSocket::get_port);
	ClassDB::bind_method(D_METHOD("get_inner_port"), &SealedSocket::get_inner_port);
	ClassDB::bind_method(D_METHOD("get_state"), &SealedSocket::get_state);
	ClassDB::bind_method(D_METHOD("get_notice"), &SealedSocket::get_notice);
	ClassDB::bind_method(D_METHOD("get_server_version"), &SealedSocket::get_server_version);
	ClassDB::bind_method(D_METHOD("is_locked"), &SealedSocket::is_locked);
	ClassDB::bind_method(D_METHOD("get_exporter"), &SealedSocket::get_exporter);
	ClassDB::bind_method(D_METHOD("get_return_tag"), &SealedSocket::get_return_tag);
	ClassDB::bind_method(D_METHOD("get_server_key"), &SealedSocket::get_server_key);
	ClassDB::bind_method(D_METHOD("get_silent_usec"), &SealedSocket::get_silent_usec);
	ClassDB::bind_method(D_METHOD("get_max_datagram"), &SealedSocket::get_max_datagram);
	ClassDB::bind_method(D_METHOD("describe", "inner_address"), &SealedSocket::describe);
	ClassDB::bind_method(D_METHOD("name", "inner_address", "peer"), &SealedSocket::name);
	ClassDB::bind_method(D_METHOD("send_fast", "peer", "bytes"), &SealedSocket::send_fast);
	ClassDB::bind_method(D_METHOD("send_fast_each", "peers", "datagrams"), &SealedSocket::send_fast_each);
	ClassDB::bind_method(D_METHOD("take_fast", "ticks_usec"), &SealedSocket::take_fast);
	ClassDB::bind_method(D_METHOD("admit", "inner_address"), &SealedSocket::admit);
	ClassDB::bind_method(D_METHOD("take_refusal"), &SealedSocket::take_refusal);
	ClassDB::bind_method(D_METHOD("stats"), &SealedSocket::stats);

	BIND_CONSTANT(WIDE_DATAGRAM);
	BIND_ENUM_CONSTANT(STATE_CLOSED);
	BIND_ENUM_CONSTANT(STATE_OPENING);
	BIND_ENUM_CONSTANT(STATE_OPEN);
	BIND_ENUM_CONSTANT(STATE_FAILED);
	BIND_ENUM_CONSTANT(NOTICE_NONE);
	BIND_ENUM_CONSTANT(NOTICE_WRONG_PASSWORD);
	BIND_ENUM_CONSTANT(NOTICE_LATER);
	BIND_ENUM_CONSTANT(NOTICE_OTHER_VERSION);
	BIND_ENUM_CONSTANT(NOTICE_SERVER_IS_OPEN);
	BIND_ENUM_CONSTANT(NOTICE_SERVER_SEALS);
	BIND_ENUM_CONSTANT(NOTICE_ASKS_FOR_NO_PASSWORD);
	BIND_ENUM_CONSTANT(NOTICE_OTHER_KEY);
}

} // namespace godot
