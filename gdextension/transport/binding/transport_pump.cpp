// SPDX-License-Identifier: MIT
#include "transport_pump.hpp"

#include "../src/clock.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

namespace godot {

namespace {

/// ENet sends again and pings only when it is served: no later than this, ms.
constexpr int64_t MAX_WAIT_MS = 50;

/// Events that are taken before what came is handed over.
constexpr int64_t MAX_EVENTS = 128;

bool is_none(const Array &p_event) {
	return int64_t(p_event[0]) == ENetConnection::EVENT_NONE;
}

Array event_of(ENetConnection::EventType p_type) {
	Array made;
	made.push_back(p_type);
	return made;
}

} // namespace

void TransportPump::attach(const Ref<ENetConnection> &p_host, const Ref<SealedSocket> &p_socket) {
	ERR_FAIL_COND_MSG(p_host.is_null() || p_socket.is_null(), "A pump serves a host and its socket: found none.");
	_host = p_host;
	_socket = p_socket;
	_wait.open(_socket->descriptor());
}

void TransportPump::detach() {
	_wait.close();
	_host.unref();
	_socket.unref();
}

Array TransportPump::serve(bool p_first, int64_t p_max_wait_usec) {
	if (_host.is_null()) {
		return event_of(ENetConnection::EVENT_ERROR);
	}
	if (p_first) {
		_left = MAX_EVENTS;
	}
	Array event = p_first ? wait_for_event(p_max_wait_usec) : next_event();
	if (p_first && _busy) {
		expect();
	}
	_left--;
	return event;
}

Array TransportPump::wait_for_event(int64_t p_max_wait_usec) {
	int64_t now = transport::now_usec();
	const int64_t until_usec = now + p_max_wait_usec;
	const SealedSocket::State state = _socket->get_state();
	int64_t due_usec = _socket->take_in(now);
	Array event = _host->service(0);
	while (is_none(event) && !_socket->has_fast()) {
		now = transport::now_usec();
		_socket->send_out(now);
		if (now >= until_usec || _wait.take() || _socket->get_state() != state) {
			break;
		}
		const int64_t left_usec = std::min(until_usec, due_usec) - now;
		// Rounded up: the last wait would be many of no time.
		_wait.wait(int(std::clamp<int64_t>((left_usec + 999) / 1000, 1, MAX_WAIT_MS)));
		due_usec = _socket->take_in(transport::now_usec());
		event = _host->service(0);
	}
	return event;
}

Array TransportPump::next_event() {
	return _left > 0 ? _host->service(0) : event_of(ENetConnection::EVENT_NONE);
}

/// To find that nothing is left takes ENet as long as the rest, as it looks at all its slots: so a busy
/// thread asks for no more events than datagrams have come. What is left nevertheless comes with the
/// next turn.
void TransportPump::expect() {
	const int64_t came = int64_t(_host->pop_statistic(ENetConnection::HOST_TOTAL_RECEIVED_PACKETS));
	if (came > 0) {
		_left = std::min(came, MAX_EVENTS);
	}
}

void TransportPump::send_out() {
	if (_socket.is_valid()) {
		_socket->send_out(transport::now_usec());
	}
}

void TransportPump::wake() {
	_wait.wake();
}

void TransportPump::note_handed_over() {
	_pause.handed_over(transport::now_usec());
}

void TransportPump::pause() {
	std::this_thread::sleep_for(std::chrono::microseconds(_pause.usec(transport::now_usec())));
}

void TransportPump::_bind_methods() {
	ClassDB::bind_method(D_METHOD("attach", "host", "socket"), &TransportPump::attach);
	ClassDB::bind_method(D_METHOD("detach"), &TransportPump::detach);
	ClassDB::bind_method(D_METHOD("serve", "first", "max_wait_usec"), &TransportPump::serve);
	ClassDB::bind_method(D_METHOD("set_busy", "busy"), &TransportPump::set_busy);
	ClassDB::bind_method(D_METHOD("send_out"), &TransportPump::send_out);
	ClassDB::bind_method(D_METHOD("wake"), &TransportPump::wake);
	ClassDB::bind_method(D_METHOD("note_handed_over"), &TransportPump::note_handed_over);
	ClassDB::bind_method(D_METHOD("pause"), &TransportPump::pause);
}

} // namespace godot
