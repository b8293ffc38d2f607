// SPDX-License-Identifier: MIT
#pragma once

#include "../src/relay/client_relay.hpp"
#include "../src/relay/relay_socket.hpp"
#include "../src/relay/server_relay.hpp"
#include "fast_queue.hpp"
#include "traffic_count.hpp"

#include <godot_cpp/classes/e_net_connection.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <vector>

namespace godot {

/// The real UDP port of an ENet host. Documented in doc_classes/SealedSocket.xml.
class SealedSocket : public RefCounted, private transport::RelaySink {
	GDCLASS(SealedSocket, RefCounted)

public:
	enum State {
		STATE_CLOSED,
		STATE_OPENING,
		STATE_OPEN,
		STATE_FAILED,
	};
	enum Notice {
		NOTICE_NONE,
		NOTICE_WRONG_PASSWORD,
		NOTICE_LATER,
		NOTICE_OTHER_VERSION,
		NOTICE_SERVER_IS_OPEN,
		NOTICE_SERVER_SEALS,
		NOTICE_ASKS_FOR_NO_PASSWORD,
		NOTICE_OTHER_KEY,
	};

	/// Bytes of a datagram that fits into what the Internet asks of every network (IPv6: 1280).
	static constexpr int WIDE_DATAGRAM = int(transport::PathMtu::SIZES[1]);

	void set_sealing(bool p_seals, int64_t p_version);
	void set_passwords(const PackedStringArray &p_of_roles);
	void set_client(int64_t p_role, const String &p_password, const PackedByteArray &p_return_tag);
	void set_server_key(const PackedByteArray &p_seed);
	void set_known_key(const PackedByteArray &p_key);
	void set_limits(int64_t p_max_packet, int64_t p_min_channels, int64_t p_slots);
	Error set_announcement(const PackedByteArray &p_body);
	Error open_server(const String &p_address, int64_t p_port);
	Error open_client(const String &p_address, int64_t p_port);
	Error tie(const Ref<ENetConnection> &p_host);
	void close();

	int64_t get_port() const;
	int64_t get_inner_port() const;
	State get_state() const;
	Notice get_notice() const;
	int64_t get_server_version() const;
	bool is_locked() const;
	PackedByteArray get_exporter() const;
	PackedByteArray get_return_tag() const;
	PackedByteArray get_server_key() const;
	int64_t get_silent_usec() const;
	int64_t get_max_datagram() const;
	Dictionary describe(const String &p_inner_address);
	void name(const String &p_inner_address, int64_t p_peer);
	void admit(const String &p_inner_address);
	void send_fast(int64_t p_peer, const PackedByteArray &p_bytes);
	void send_fast_each(const PackedInt32Array &p_peers, const TypedArray<PackedByteArray> &p_datagrams);
	TypedArray<FastPacket> take_fast(int64_t p_ticks_usec) { return _fast.take(p_ticks_usec); }
	Dictionary take_refusal();
	Dictionary stats() const;

	/// Hands ENet what has come from the network. Returns when it must be called again at the latest,
	/// us.
	int64_t take_in(int64_t p_now_usec);
	/// Hands the network what ENet has sent.
	void send_out(int64_t p_now_usec);
	/// Whether take_fast has something to take.
	bool has_fast() const { return !_fast.is_empty(); }
	/// The descriptor to watch.
	int descriptor() const { return _socket.outer(); }

protected:
	static void _bind_methods();

private:
	void to_outer(const transport::Endpoint &p_to, const transport::View &p_bytes) override;
	void to_inner(uint32_t p_from, const transport::View &p_bytes) override;
	void to_program(int64_t p_peer, const transport::View &p_bytes) override;
	void follow_route(int64_t p_now_usec);

	transport::ServerRelay::Settings _settings;
	transport::ClientRelay::Settings _client_settings;
	transport::RelaySocket _socket;
	transport::Bytes _announcement;
	std::unique_ptr<transport::ServerRelay> _server;
	std::unique_ptr<transport::ClientRelay> _client;
	transport::Endpoint _server_at;
	size_t _handed_in = 0;
	uint64_t _refusals_taken = 0;
	int64_t _looked_usec = 0;
	FastQueue _fast;
	TrafficCount _traffic;
};

} // namespace godot

VARIANT_ENUM_CAST(SealedSocket::State);
VARIANT_ENUM_CAST(SealedSocket::Notice);
