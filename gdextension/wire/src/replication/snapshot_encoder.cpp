// SPDX-License-Identifier: MIT
#include "replication/snapshot_encoder.hpp"

#include <algorithm>
#include <cstring>

namespace wire {

namespace {

// Share of a client's bytes that people leave to bodies and fields that wait, if these need as much. Fields get half
// of it, if they need as much.
constexpr double THINGS_SHARE = 0.6;
// Snapshots' worth of bytes that a client may save up.
constexpr double MAX_SAVED = 4.0;
// A client that has acknowledged nothing for this part of a second is silent.
constexpr uint32_t SILENT_PART = 4;
// With nothing to send, a datagram keeps the clocks in step every half second.
constexpr uint32_t SILENCES_PER_SECOND = 2;

} // namespace

SnapshotEncoder::SnapshotEncoder(const Skeleton &p_skeleton, double p_max_error_deg, int p_tick_rate) :
		_history(p_skeleton, PersonLattice(PersonLattice::resolution_for(p_max_error_deg)), p_tick_rate),
		_people(_history, _visibility, p_skeleton, PersonLattice::resolution_for(p_max_error_deg)),
		_bodies(_history, _visibility),
		_fields(_history, _visibility) {}

void SnapshotEncoder::add_client(int p_client, int p_snapshots_per_second, double p_bits_per_second) {
	const int rate =
			std::clamp(p_snapshots_per_second <= 0 ? _history.rate() : p_snapshots_per_second, 1, _history.rate());
	_clients[p_client] = std::make_unique<ClientRecord>(rate, bytes_per_tick(p_bits_per_second));
}

void SnapshotEncoder::set_bandwidth(int p_client, double p_bits_per_second) {
	ClientRecord *record = client(p_client);
	if (record != nullptr) {
		record->bytes_per_tick = bytes_per_tick(p_bits_per_second);
	}
}

double SnapshotEncoder::bytes_per_tick(double p_bits_per_second) const {
	// Written so that NaN counts as the least.
	const double bits = p_bits_per_second > 1000.0 ? p_bits_per_second : 1000.0;
	return bits / 8.0 / _history.rate();
}

void SnapshotEncoder::add_recorder(int p_client) {
	add_client(p_client, 0, 0.0);
	_clients[p_client]->is_recorder = true;
}

void SnapshotEncoder::remove_entity(uint16_t p_entity) {
	_history.set_frame(p_entity, 0);
	_history.entities().remove(p_entity);
}

void SnapshotEncoder::set_command_ack(int p_client, uint16_t p_number) {
	ClientRecord *record = client(p_client);
	if (record != nullptr && (!record->has_command || record->command != p_number)) {
		record->has_command = true;
		record->command = p_number;
		record->is_command_acked = false;
	}
}

bool SnapshotEncoder::set_motion_ack(int p_client, const uint8_t *p_bytes, std::size_t p_size) {
	ClientRecord *record = client(p_client);
	if (record == nullptr || p_size != MOTION_ACK_BYTES) {
		return false;
	}
	std::copy_n(p_bytes, p_size, record->motion_ack.begin());
	record->owes_motion_ack = true;
	return true;
}

ClientRecord *SnapshotEncoder::client(int p_client) {
	const auto found = _clients.find(p_client);
	return found == _clients.end() ? nullptr : found->second.get();
}

void SnapshotEncoder::set_mark(const Mark &p_mark) {
	for (std::size_t i = 0; i < _history.people().size(); i++) {
		if (_history.people()[i]->is_there && _history.people()[i]->id == p_mark.person) {
			_marks.resize(std::max(_marks.size(), i + 1));
			_mark_ticks.resize(_marks.size(), NEVER);
			_marks[i] = p_mark;
			_mark_ticks[i] = _history.tick();
		}
	}
}

// Message, flags, number of people and of the datagram, tick, usual baseline, mark, acknowledgements.
void SnapshotEncoder::_write_header(ClientRecord &p_client, Draft &p_draft, int64_t p_now_usec) {
	Datagram &out = p_draft.out;
	// After a silence the client may be so far behind that low bytes of ticks and numbers mislead it.
	const bool is_silent = p_client.heard_tick == NEVER ||
			_history.tick() - p_client.heard_tick > uint32_t(_history.rate()) / SILENT_PART;
	const bool is_key = is_silent || p_client.key_in == 0;
	p_client.key_in = is_key ? std::size_t(p_client.rate) : p_client.key_in - 1;
	out.bytes[0] = uint8_t(is_key ? Message::KEY : Message::SNAPSHOT);
	out.bytes[3] = p_draft.entry.number;
	out.size = 4;
	const int tick_bytes = is_key ? 4 : 1;
	put_number(&out.bytes[out.size], _history.tick(), tick_bytes);
	out.size += std::size_t(tick_bytes);
	if (is_key) {
		out.bytes[out.size++] = uint8_t(_history.rate());
	}
	out.bytes[out.size++] = p_draft.usual.pack();
	if (_write_mark(p_client, p_draft, p_now_usec)) {
		p_draft.flags |= HAS_MARK;
	}
	_write_acks(p_client, p_draft);
}

void SnapshotEncoder::_write_acks(ClientRecord &p_client, Draft &p_draft) {
	Datagram &out = p_draft.out;
	if (!p_client.is_command_acked) {
		put_number(&out.bytes[out.size], p_client.command, 2);
		out.size += 2;
		p_draft.flags |= HAS_COMMAND_ACK;
		p_draft.entry.has_command_ack = true;
		p_draft.entry.command_ack = p_client.command;
	}
	if (p_client.owes_motion_ack) {
		std::memcpy(&out.bytes[out.size], p_client.motion_ack.data(), MOTION_ACK_BYTES);
		out.size += MOTION_ACK_BYTES;
		p_draft.flags |= HAS_MOTION_ACK;
		p_client.owes_motion_ack = false;
	}
}

// Fills in what is known at the end. One person alone needs neither flags nor number of people.
void SnapshotEncoder::_finish(Draft &p_draft) {
	Datagram &out = p_draft.out;
	out.bytes[1] = p_draft.flags;
	out.bytes[2] = p_draft.entry.people_count;
	if (out.bytes[0] == uint8_t(Message::SNAPSHOT) && p_draft.flags == 0 && p_draft.entry.people_count == 1) {
		out.bytes[0] = uint8_t(Message::SNAPSHOT_OF_ONE);
		out.size -= 2;
		std::memmove(&out.bytes[1], &out.bytes[3], out.size - 1);
	}
}

bool SnapshotEncoder::_write_mark(ClientRecord &p_client, Draft &p_draft, int64_t p_now_usec) {
	const uint32_t tick = _history.tick();
	const uint32_t period = p_client.wants_marks ? 1 : uint32_t(std::max(1, _history.rate() / MARKS_PER_SECOND));
	if (_marks.empty() || (p_client.mark_tick != NEVER && tick - p_client.mark_tick < period)) {
		return false;
	}
	for (std::size_t i = 0; i < _marks.size(); i++) {
		const std::size_t index = (p_client.marked + 1 + i) % _marks.size();
		if (_mark_ticks[index] != tick || !_history.people()[index]->is_there) {
			continue;
		}
		Mark mark = _marks[index];
		const int64_t wait = std::clamp<int64_t>((p_now_usec - mark.simulated_usec) / Mark::STEP_USEC, 0, 65535);
		mark.steps[3] = uint16_t(wait);
		uint8_t *at = &p_draft.out.bytes[p_draft.out.size];
		put_number(at, mark.person, 2);
		put_number(at + 2, mark.sample, 4);
		put_number(at + 6, uint64_t(mark.simulated_usec), 8);
		for (std::size_t step = 0; step < mark.steps.size(); step++) {
			put_number(at + 14 + 2 * step, mark.steps[step], 2);
		}
		p_draft.out.size += Mark::BYTES;
		p_client.marked = index;
		p_client.mark_tick = tick;
		return true;
	}
	return false;
}

// Whether a snapshot is due: evenly, also where the rates do not divide each other.
bool SnapshotEncoder::_is_due(const ClientRecord &p_client) const {
	const auto snapshots = [&](uint32_t p_tick) {
		return uint64_t(p_tick) * uint64_t(p_client.rate) / uint64_t(_history.rate());
	};
	return p_client.last_tick == NEVER || snapshots(_history.tick()) != snapshots(p_client.last_tick);
}

// Writes the most urgent of what waits; false if nothing of it has room.
bool SnapshotEncoder::_write_datagram(ClientRecord &p_client, Datagram &r_out, std::size_t p_room, int64_t p_now_usec) {
	Draft draft{ r_out, p_client.begin_datagram(_history.tick()), _people.find_usual(p_client), p_room };
	_write_header(p_client, draft, p_now_usec);
	const double share = double(p_room) * THINGS_SHARE;
	const double fields = std::min(_fields.expected_bytes(), share / 2.0);
	const double bodies = _bodies.expected_bytes();
	_people.write(p_client, draft, p_room - std::size_t(std::min(bodies + fields, share)));
	// A person who does not fit is saved up for: bodies would always leave too little.
	if (draft.entry.people_count > 0 || !_people.is_waiting()) {
		_bodies.write(p_client, draft, p_room - std::size_t(fields));
		_fields.write(p_client, draft);
	}
	const bool is_empty = draft.entry.people_count == 0 && (draft.flags & ~HAS_MARK) == 0;
	if (is_empty && _is_waiting()) {
		p_client.cancel_datagram(); // It saves up for who is waiting.
		return false;
	}
	_finish(draft);
	p_client.allowance -= double(r_out.size + _datagram_overhead);
	p_client.sent_tick = _history.tick();
	p_client.stats.datagrams++;
	p_client.stats.bytes += r_out.size + _datagram_overhead;
	if (p_client.is_recorder) {
		p_client.keep_datagram(draft.entry);
	}
	return true;
}

std::size_t SnapshotEncoder::encode(int p_client, int64_t p_now_usec, DatagramList &r_datagrams) {
	ClientRecord *client = this->client(p_client);
	if (client == nullptr || _history.tick() == NEVER || client->last_tick == _history.tick()) {
		return 0;
	}
	client->follow(_history);
	client->expire(_history.tick(), _history.rate());
	client->allowance = std::min(client->allowance + client->bytes_per_tick,
			std::max(client->bytes_per_tick * _history.rate() / client->rate * MAX_SAVED, double(MAX_BYTES)));
	const bool is_due = _is_due(*client);
	if (!is_due && !_history.has_jolts()) {
		return 0;
	}
	_people.collect(*client, !is_due);
	_bodies.collect(*client, !is_due);
	if (is_due) {
		_fields.collect(*client);
		client->last_tick = _history.tick();
	} else {
		_fields.collect_nothing();
	}
	const bool is_silent = !_is_waiting() && client->is_command_acked && !client->owes_motion_ack;
	const uint32_t silence = uint32_t(_history.rate()) / SILENCES_PER_SECOND;
	if (is_silent && client->sent_tick != NEVER && _history.tick() - client->sent_tick < silence) {
		return 0;
	}
	const std::size_t most = client->is_recorder ? MAX_RECORDED : MAX_DATAGRAMS;
	std::size_t count = 0;
	while (count < most && (count == 0 || _is_waiting())) {
		const double left = client->is_recorder ? double(MAX_BYTES) : client->allowance - double(_datagram_overhead);
		const double room = std::min(left, double(MAX_BYTES));
		if (room < double(BodiesWriter::WORST_BODY)) {
			break;
		}
		if (!_write_datagram(*client, r_datagrams.add(), std::size_t(room), p_now_usec)) {
			r_datagrams.remove_last();
			break;
		}
		count++;
	}
	return count;
}

} // namespace wire
