// SPDX-License-Identifier: MIT
#include "enet_guard.hpp"

namespace transport {

namespace {

/// How far a number is ahead of another; numbers wrap.
uint16_t ahead_of(uint16_t p_number, uint16_t p_base) {
	return uint16_t(p_number - p_base);
}

/// ENet writes no more commands in a datagram. More would be cheap to send: 300 of them fit, each of
/// which ENet answers.
constexpr int MAX_COMMANDS = 32;
/// ENet answers no CONNECT that asks for more.
constexpr uint32_t MAX_CHANNELS = 255;
/// What ENet spends on a packet besides its bytes, about.
constexpr uint32_t PACKET_COST = 128;

bool is_behind(uint16_t p_number, uint16_t p_base) {
	return p_number == p_base || ahead_of(p_number, p_base) >= 0x8000;
}

} // namespace

EnetGuard::~EnetGuard() {
	release(_held);
}

EnetGuard::Verdict EnetGuard::check(const View &p_datagram) {
	// Once to see that it is whole: nothing of a datagram counts that is dropped.
	EnetReader reader(p_datagram);
	EnetCommand command;
	int count = 0;
	while (reader.next(command) && ++count <= MAX_COMMANDS) {
	}
	if (!reader.is_valid() || count > MAX_COMMANDS) {
		return MALFORMED;
	}
	reader = EnetReader(p_datagram);
	const bool connects = reader.peer() == EnetReader::NO_PEER;
	while (reader.next(command)) {
		if (connects != (command.kind == EnetCommand::CONNECT)) {
			return MALFORMED;
		}
		const Verdict verdict = connects ? check_connect(command) : check_command(command);
		if (verdict != PASS) {
			return verdict;
		}
	}
	_confirmed = _confirmed || (!connects && _has_peer);
	return PASS;
}

EnetGuard::Verdict EnetGuard::check_connect(const EnetCommand &p_command) {
	if (p_command.channels > MAX_CHANNELS) {
		return MALFORMED;
	}
	if (p_command.channels < _limits->min_channels) {
		return TOO_FEW_CHANNELS;
	}
	if (p_command.chosen != _chosen) {
		// One of ENet's slots for each link: who wants another connection makes another handshake.
		if (_confirmed || _has_chosen) {
			return CONNECTED_ALREADY;
		}
		_has_chosen = true;
		_chosen = p_command.chosen;
		restart();
	}
	return PASS;
}

EnetGuard::Verdict EnetGuard::check_command(const EnetCommand &p_command) {
	if (!_limits->bounded) {
		return PASS;
	}
	switch (p_command.kind) {
		case EnetCommand::SEND_RELIABLE:
			return check_reliable(p_command.channel, p_command.number, 1, uint32_t(p_command.size));
		case EnetCommand::SEND_FRAGMENT:
			return check_fragment(p_command);
		case EnetCommand::SEND_UNRELIABLE_FRAGMENT:
			return BAD_FRAGMENT;
		case EnetCommand::SEND_UNRELIABLE:
			return check_unreliable(p_command);
		default:
			return PASS;
	}
}

EnetGuard::Verdict EnetGuard::check_reliable(uint8_t p_channel, uint16_t p_first, uint16_t p_span, uint32_t p_size) {
	if (p_channel >= CHANNELS) {
		return MALFORMED;
	}
	if (!_admitted && p_channel != 0) {
		return HELD_TOO_MUCH;
	}
	Channel &at = channel(p_channel);
	// What is behind ENet has: it drops it, and acknowledges it again.
	if (is_behind(p_first, at.taken)) {
		return PASS;
	}
	if (ahead_of(p_first, at.taken) + p_span >= int(AHEAD)) {
		return HELD_TOO_MUCH;
	}
	const uint32_t size = p_size + PACKET_COST;
	Slot &begin = at.slots[p_first % AHEAD];
	if (begin.claimed) {
		return begin.first == p_first && begin.span == p_span && begin.charge == size ? PASS : BAD_FRAGMENT;
	}
	for (uint16_t i = 0; i < p_span; i++) {
		if (at.slots[uint16_t(p_first + i) % AHEAD].claimed) {
			return BAD_FRAGMENT;
		}
	}
	// The whole packet is reserved with whichever fragment comes first.
	if (!charge(size)) {
		return HELD_TOO_MUCH;
	}
	for (uint16_t i = 0; i < p_span; i++) {
		Slot &slot = at.slots[uint16_t(p_first + i) % AHEAD];
		slot.claimed = true;
		slot.first = p_first;
	}
	begin.span = p_span;
	begin.charge = size;
	return PASS;
}

EnetGuard::Verdict EnetGuard::check_fragment(const EnetCommand &p_command) {
	const EnetCommand &it = p_command;
	const bool last = it.fragment + 1 == it.fragments;
	// ENet cuts a packet in equal parts, the last may be shorter.
	const bool fits = it.fragments >= 2 && it.fragments < AHEAD && it.fragment < it.fragments && it.size > 0 &&
			it.whole_size <= _limits->max_packet && it.offset < it.whole_size && it.size <= it.whole_size - it.offset &&
			last == (it.offset + it.size == it.whole_size) &&
			(it.fragment == 0 ? it.offset == 0 : it.offset % it.fragment == 0) &&
			it.number == uint16_t(it.first_number + it.fragment);
	return fits ? check_reliable(it.channel, it.first_number, uint16_t(it.fragments), it.whole_size) : BAD_FRAGMENT;
}

EnetGuard::Verdict EnetGuard::check_unreliable(const EnetCommand &p_command) {
	if (p_command.channel >= CHANNELS) {
		return MALFORMED;
	}
	if (!_admitted && p_command.channel != 0) {
		return HELD_TOO_MUCH;
	}
	Channel &at = channel(p_command.channel);
	if (is_behind(p_command.number, at.taken)) {
		return PASS;
	}
	const uint32_t size = uint32_t(p_command.size) + PACKET_COST;
	if (!charge(size)) {
		return HELD_TOO_MUCH;
	}
	at.waiting += size;
	if (at.waiting == size || !is_behind(p_command.number, at.waiting_until)) {
		at.waiting_until = p_command.number;
	}
	return PASS;
}

void EnetGuard::note_sent(const View &p_datagram) {
	EnetReader reader(p_datagram);
	EnetCommand command;
	while (reader.next(command)) {
		if (command.kind == EnetCommand::ACKNOWLEDGE && command.channel < CHANNELS) {
			take(channel(command.channel), command.number);
		} else if (command.kind == EnetCommand::DISCONNECT) {
			// ENet frees what it holds for the peer.
			restart();
		} else if (command.kind == EnetCommand::VERIFY_CONNECT) {
			_has_peer = true;
			_peer = command.peer;
			_session = command.outgoing_session;
		}
	}
}

void EnetGuard::take(Channel &r_channel, uint16_t p_number) {
	if (is_behind(p_number, r_channel.taken) || ahead_of(p_number, r_channel.taken) >= AHEAD) {
		return;
	}
	Slot &one = r_channel.slots[p_number % AHEAD];
	one.acknowledged = one.claimed;
	while (hand_on(r_channel)) {
	}
	if (r_channel.waiting > 0 && is_behind(r_channel.waiting_until, r_channel.taken)) {
		release(r_channel.waiting);
		r_channel.waiting = 0;
	}
}

/// Whether ENet has had the next packet whole, and has handed it on.
bool EnetGuard::hand_on(Channel &r_channel) {
	const uint16_t first = uint16_t(r_channel.taken + 1);
	const uint16_t span = r_channel.slots[first % AHEAD].span;
	for (uint16_t i = 0; i < span; i++) {
		if (!r_channel.slots[uint16_t(first + i) % AHEAD].acknowledged) {
			return false;
		}
	}
	if (span > 0) {
		release(r_channel.slots[first % AHEAD].charge);
	}
	for (uint16_t i = 0; i < span; i++) {
		r_channel.slots[uint16_t(first + i) % AHEAD] = Slot();
	}
	r_channel.taken = uint16_t(r_channel.taken + span);
	return span > 0;
}

bool EnetGuard::charge(uint32_t p_bytes) {
	const uint64_t own = uint64_t(_held) + p_bytes;
	const uint32_t max_held = _admitted ? _limits->max_held : _limits->max_held_arriving;
	if (own > max_held || (own > _limits->own_part && *_held_in_all + p_bytes > _limits->max_held_in_all)) {
		return false;
	}
	_held += p_bytes;
	*_held_in_all += p_bytes;
	return true;
}

void EnetGuard::release(uint32_t p_bytes) {
	_held -= p_bytes;
	*_held_in_all -= p_bytes;
}

/// The peer begins anew, with all numbers at 0.
void EnetGuard::restart() {
	for (std::unique_ptr<Channel> &one : _channels) {
		one.reset();
	}
	release(_held);
	_has_peer = false;
	_confirmed = false;
	_admitted = false;
}

EnetGuard::Channel &EnetGuard::channel(uint8_t p_number) {
	if (!_channels[p_number]) {
		_channels[p_number] = std::make_unique<Channel>();
	}
	return *_channels[p_number];
}

} // namespace transport
