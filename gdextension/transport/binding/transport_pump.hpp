// SPDX-License-Identifier: MIT
#pragma once

#include "../src/batch_pause.hpp"
#include "../src/socket_wait.hpp"
#include "sealed_socket.hpp"

#include <godot_cpp/classes/e_net_connection.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/array.hpp>

namespace godot {

/// Serves an ENet host in a thread. Documented in doc_classes/TransportPump.xml.
class TransportPump : public RefCounted {
	GDCLASS(TransportPump, RefCounted)

public:
	void attach(const Ref<ENetConnection> &p_host, const Ref<SealedSocket> &p_socket);
	void detach();
	void set_busy(bool p_busy) { _busy = p_busy; }
	Array serve(bool p_first, int64_t p_max_wait_usec);
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

	Ref<ENetConnection> _host;
	Ref<SealedSocket> _socket;
	int64_t _left = 0;
	bool _busy = false;
	transport::SocketWait _wait;
	transport::BatchPause _pause;
};

} // namespace godot
