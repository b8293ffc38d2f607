// SPDX-License-Identifier: MIT
#include "transport_pump.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

namespace godot {

namespace {

/// ENet sends again and pings only when it is served: no later than this, ms.
constexpr int64_t MAX_WAIT_MS = 50;

int64_t now_usec() {
	const auto now = std::chrono::steady_clock::now().time_since_epoch();
	return std::chrono::duration_cast<std::chrono::microseconds>(now).count();
}

bool is_none(const Array &p_event) {
	return int64_t(p_event[0]) == ENetConnection::EVENT_NONE;
}

} // namespace

void TransportPump::attach(const Ref<ENetConnection> &p_host, bool p_watch_socket) {
	ERR_FAIL_COND_MSG(p_host.is_null(), "A pump serves a host: found none.");
	_host = p_host;
	_wait.close();
	if (p_watch_socket) {
		_wait.open(uint16_t(_host->get_local_port()));
	}
}

void TransportPump::detach() {
	_wait.close();
	_host.unref();
}

bool TransportPump::is_watching() const {
	return _wait.is_open();
}

Array TransportPump::serve(bool p_wait, int64_t p_max_wait_usec, int64_t p_blind_wait_ms) {
	if (_host.is_null()) {
		Array error;
		error.push_back(ENetConnection::EVENT_ERROR);
		return error;
	}
	if (!_wait.is_open()) {
		return _host->service(p_wait ? int32_t(p_blind_wait_ms) : 0);
	}
	const int64_t until_usec = now_usec() + p_max_wait_usec;
	Array event = _host->service(0);
	while (p_wait && is_none(event)) {
		const int64_t left_usec = until_usec - now_usec();
		if (_wait.take() || left_usec <= 0) {
			break;
		}
		// Rounded up: the last wait would be many of no time.
		_wait.wait(int(std::clamp<int64_t>((left_usec + 999) / 1000, 1, MAX_WAIT_MS)));
		event = _host->service(0);
	}
	return event;
}

void TransportPump::wake() {
	_wait.wake();
}

void TransportPump::note_handed_over() {
	_pause.handed_over(now_usec());
}

void TransportPump::pause() {
	std::this_thread::sleep_for(std::chrono::microseconds(_pause.usec(now_usec())));
}

void TransportPump::_bind_methods() {
	ClassDB::bind_method(D_METHOD("attach", "host", "watch_socket"), &TransportPump::attach);
	ClassDB::bind_method(D_METHOD("detach"), &TransportPump::detach);
	ClassDB::bind_method(D_METHOD("is_watching"), &TransportPump::is_watching);
	ClassDB::bind_method(D_METHOD("serve", "wait", "max_wait_usec", "blind_wait_ms"), &TransportPump::serve);
	ClassDB::bind_method(D_METHOD("wake"), &TransportPump::wake);
	ClassDB::bind_method(D_METHOD("note_handed_over"), &TransportPump::note_handed_over);
	ClassDB::bind_method(D_METHOD("pause"), &TransportPump::pause);
}

} // namespace godot
