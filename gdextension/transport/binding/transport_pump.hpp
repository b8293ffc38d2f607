// SPDX-License-Identifier: MIT
#pragma once

#include "../src/batch_pause.hpp"
#include "../src/socket_wait.hpp"
#include "fast_packet.hpp"
#include "sealed_socket.hpp"

#include <godot_cpp/classes/e_net_connection.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <vector>

namespace godot {

/// Serves an ENet host in a thread. Documented in doc_classes/TransportPump.xml.
class TransportPump : public RefCounted {
	GDCLASS(TransportPump, RefCounted)

public:
	void attach(const Ref<ENetConnection> &p_host, const Ref<SealedSocket> &p_socket, int64_t p_fast_channel);
	void detach();
	void set_busy(bool p_busy) { _busy = p_busy; }
	Array serve(bool p_first, int64_t p_max_wait_usec);
	TypedArray<FastPacket> take_fast(int64_t p_ticks_usec);
	int64_t take_received();
	void send_out();
	void wake();
	void note_handed_over();
	void pause();

protected:
	static void _bind_methods();

private:
	Array wait_for_event(int64_t p_max_wait_usec);
	Array next_event();
	void expect();
	bool keep_if_fast(const Array &p_event);

	Ref<ENetConnection> _host;
	Ref<SealedSocket> _socket;
	TypedArray<FastPacket> _fast;
	// The same again: an Array gives its elements away more slowly.
	std::vector<FastPacket *> _arrived;
	StringName _id = StringName("id");
	int64_t _fast_channel = -1;
	// Packets that ENet has counted, and nobody has taken yet.
	int64_t _received = 0;
	int64_t _left = 0;
	bool _busy = false;
	transport::SocketWait _wait;
	transport::BatchPause _pause;
};

} // namespace godot
