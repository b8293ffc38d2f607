// SPDX-License-Identifier: MIT
#pragma once

#include "../src/batch_pause.hpp"
#include "../src/socket_wait.hpp"

#include <godot_cpp/classes/e_net_connection.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/array.hpp>

namespace godot {

/// Serves an ENet host in a thread. Documented in doc_classes/TransportPump.xml.
class TransportPump : public RefCounted {
	GDCLASS(TransportPump, RefCounted)

public:
	void attach(const Ref<ENetConnection> &p_host, bool p_watch_socket);
	void detach();
	bool is_watching() const;
	Array serve(bool p_wait, int64_t p_max_wait_usec, int64_t p_blind_wait_ms);
	void wake();
	void note_handed_over();
	void pause();

protected:
	static void _bind_methods();

private:
	Ref<ENetConnection> _host;
	transport::SocketWait _wait;
	transport::BatchPause _pause;
};

} // namespace godot
