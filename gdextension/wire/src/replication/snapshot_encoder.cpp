// SPDX-License-Identifier: MIT
#include "replication/snapshot_encoder.hpp"

#include "replication/body_codec.hpp"
#include "replication/entry_coding.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace wire {

namespace {

// Share of a client's bytes that people leave to bodies that wait, if these need as much.
constexpr double BODIES_SHARE = 0.6;
// Urgency at which somebody out of sight is sent after all.
constexpr float HIDDEN_URGENCY = 0.75f;
// Of what is out of sight only a coarse position is needed: so many times the tolerance.
constexpr float HIDDEN_TOLERANCE = 8.0f;
// Errors beyond so many tolerances are all alike.
constexpr float MAX_ERROR = 20.0f;
// Added where the receiver believes something that is plainly wrong.
constexpr float URGENT = 1000.0f;
// Snapshots' worth of bytes that a client may save up.
constexpr double MAX_SAVED = 4.0;
// A client that has acknowledged nothing for this part of a second is silent.
constexpr uint32_t SILENT_PART = 4;
// Bytes that a body usually takes at most, and those that the worst takes, with the end of the coder.
constexpr std::size_t BODY_MARGIN = 16;
constexpr std::size_t WORST_BODY = 96;
// With nothing to send, a datagram keeps the clocks in step every half second.
constexpr uint32_t SILENCES_PER_SECOND = 2;
constexpr float BODY_SIZE_MEMORY = 0.02f;

} // namespace

SnapshotEncoder::SnapshotEncoder(const Skeleton &p_skeleton, double p_max_error_deg, int p_tick_rate) :
		_codec(p_skeleton, PersonLattice::resolution_for(p_max_error_deg)),
		_history(p_skeleton, PersonLattice(PersonLattice::resolution_for(p_max_error_deg)), p_tick_rate) {}

void SnapshotEncoder::add_client(int p_client, int p_snapshots_per_second, double p_bits_per_second) {
	const int rate =
			std::clamp(p_snapshots_per_second <= 0 ? _history.rate() : p_snapshots_per_second, 1, _history.rate());
	// Written so that NaN counts as the least.
	const double bits = p_bits_per_second > 1000.0 ? p_bits_per_second : 1000.0;
	_clients[p_client] = std::make_unique<ClientRecord>(rate, bits / 8.0 / _history.rate());
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

void SnapshotEncoder::_collect_people(ClientRecord &p_client, bool p_jolts_only) {
	_people_waiting.clear();
	for (std::size_t i = 0; i < p_client.people.size(); i++) {
		const WorldHistory::Person &person = *_history.people()[i];
		Delivery &delivery = p_client.people[i];
		if (!person.is_there || person.history.find(_history.tick()) == nullptr) {
			continue;
		}
		const bool own = int(person.id) == p_client.own_person;
		const float weight =
				own || !p_client.has_viewpoint ? 1.0f : _visibility.weight(p_client.viewpoint, person.position);
		delivery.urgency += weight;
		const bool is_due = weight >= Interest::FAR || delivery.urgency >= HIDDEN_URGENCY || delivery.sent == NEVER;
		if (p_jolts_only ? person.jolted : is_due) {
			_people_waiting.push_back({ delivery.urgency + (person.jolted ? URGENT : 0.0f), uint16_t(i) });
		}
	}
	std::sort(_people_waiting.begin(), _people_waiting.end(),
			[](const Candidate &p_a, const Candidate &p_b) { return p_a.urgency < p_b.urgency; });
}

float SnapshotEncoder::_body_error(
		const ClientRecord::BodyDelivery &p_delivery, const WorldHistory::Body &p_body) const {
	const BodyUpdate &believed = p_delivery.believed;
	if (p_body.now.at_rest && believed.at_rest && !p_delivery.is_lost) {
		// Usually nothing has happened at all.
		const Vec3 displacement = p_body.now.position - believed.position;
		if (displacement.dot(displacement) == 0.0f) {
			return 0.0f;
		}
	}
	const float seconds = float(_history.tick() - believed.tick) / float(_history.rate());
	const BodyTransform predicted = predict(believed, seconds);
	const float cosine = std::min(1.0f, std::fabs(predicted.orientation.dot(p_body.now.orientation)));
	// The chord stands for the arc: 2 sqrt(2 - 2 cos(a/2)).
	const float angle = 2.0f * std::sqrt(2.0f - 2.0f * cosine);
	return (p_body.now.position - predicted.position).length() + LEVER_M * angle;
}

void SnapshotEncoder::_collect_bodies(ClientRecord &p_client, bool p_jolts_only) {
	_bodies_waiting.clear();
	for (std::size_t i = 0; i < p_client.bodies.size(); i++) {
		const WorldHistory::Body &body = *_history.bodies()[i];
		ClientRecord::BodyDelivery &delivery = p_client.bodies[i];
		if (!body.is_there || (p_jolts_only && !body.jolted) || body.history.find(_history.tick()) == nullptr) {
			continue;
		}
		const float weight = p_client.has_viewpoint ? _visibility.weight(p_client.viewpoint, body.now.position) : 1.0f;
		const bool is_wrong = delivery.sent == NEVER || delivery.is_lost || body.jolted ||
				body.now.at_rest != delivery.believed.at_rest;
		const bool ages = !body.now.at_rest && _history.tick() - delivery.sent >= uint32_t(_history.rate());
		const float error = is_wrong ? MAX_ERROR : std::min(_body_error(delivery, body) / TOLERANCE_M, MAX_ERROR);
		if (!is_wrong && !ages && error < (weight < Interest::FAR ? HIDDEN_TOLERANCE : 1.0f)) {
			continue;
		}
		delivery.urgency = std::min(delivery.urgency + weight * error, URGENT);
		_bodies_waiting.push_back({ delivery.urgency + (is_wrong ? URGENT : 0.0f), uint16_t(i) });
	}
}

Baseline SnapshotEncoder::_baseline_of(const Delivery &p_delivery, bool p_has_before) const {
	Baseline base;
	const uint32_t tick = _history.tick();
	if (p_delivery.acked == NEVER || tick - p_delivery.acked > uint32_t(MAX_AGE) || p_delivery.acked >= tick) {
		return base;
	}
	base.age = int(tick - p_delivery.acked);
	if (p_has_before && p_delivery.before != NEVER) {
		const uint32_t spacing = p_delivery.acked - p_delivery.before;
		const bool fits = spacing <= uint32_t(Baseline::MAX_SPACING) && base.age + int(spacing) <= MAX_AGE;
		base.spacing = fits ? int(spacing) : 0;
	}
	return base;
}

Baseline SnapshotEncoder::_usual_baseline(const ClientRecord &p_client) const {
	// That of the most urgent: mostly all have the same.
	if (_people_waiting.empty()) {
		return {};
	}
	const Baseline base = _baseline_of(p_client.people[_people_waiting.back().index], true);
	return base.age <= Baseline::MAX_SHORT_AGE ? base : Baseline{};
}

void SnapshotEncoder::_write_header(ClientRecord &p_client, Draft &p_draft, int64_t p_now_usec) {
	Datagram &out = p_draft.out;
	// After a silence the client may be so far behind that low bytes of ticks and numbers mislead it.
	const bool is_silent = p_client.heard_tick == NEVER ||
			_history.tick() - p_client.heard_tick > uint32_t(_history.rate()) / SILENT_PART;
	const bool is_key = is_silent || p_client.key_in == 0;
	p_client.key_in = is_key ? std::size_t(p_client.rate) : p_client.key_in - 1;
	out.bytes[0] = uint8_t(is_key ? Kind::KEY : Kind::SNAPSHOT);
	out.bytes[1] = p_draft.entry.number;
	out.size = 2;
	const int tick_bytes = is_key ? 4 : 1;
	put_number(&out.bytes[out.size], _history.tick(), tick_bytes);
	out.size += std::size_t(tick_bytes);
	if (is_key) {
		out.bytes[out.size++] = uint8_t(_history.rate());
	}
	out.bytes[out.size++] = p_draft.usual.pack();
	if (_write_mark(p_client, p_draft, p_now_usec)) {
		out.bytes[0] |= HAS_MARKS;
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

const SnapshotEncoder::EncodedPerson &SnapshotEncoder::_encode_person(
		std::size_t p_index, const Baseline &p_base, bool p_is_usual) {
	if (_encoded_people.size() <= p_index) {
		_encoded_people.resize(p_index + 1);
		_next_encoded.resize(p_index + 1, 0);
	}
	const uint32_t tick = _history.tick();
	for (const EncodedPerson &encoded : _encoded_people[p_index]) {
		if (encoded.tick == tick && encoded.base == p_base && encoded.is_usual == p_is_usual) {
			return encoded;
		}
	}
	EncodedPerson &encoded = _encoded_people[p_index][_next_encoded[p_index]++ % MAX_ENCODINGS];
	const WorldHistory::Person &person = *_history.people()[p_index];
	encoded.tick = tick;
	encoded.base = p_base;
	encoded.is_usual = p_is_usual;
	RangeEncoder encoder(encoded.bytes.data(), encoded.bytes.size());
	encode_count(encoder, person.id, 2);
	encode_baseline(encoder, p_base, p_is_usual);
	const PersonState *base = p_base.age > 0 ? person.history.find(tick - uint32_t(p_base.age)) : nullptr;
	const int older = p_base.age + p_base.spacing;
	const PersonState *before = p_base.spacing > 0 ? person.history.find(tick - uint32_t(older)) : nullptr;
	_codec.encode(encoder, *person.history.find(tick), base, before, p_base.age, older);
	encoded.size = encoder.finish();
	return encoded;
}

void SnapshotEncoder::_write_people(ClientRecord &p_client, Draft &p_draft, std::size_t p_room) {
	SentDatagram &entry = p_draft.entry;
	while (!_people_waiting.empty() && entry.people_count < MAX_PEOPLE) {
		const std::size_t index = _people_waiting.back().index;
		const WorldHistory::Person &person = *_history.people()[index];
		Delivery &delivery = p_client.people[index];
		Baseline base = _baseline_of(delivery, true);
		if (base.age > 0 && person.history.find(delivery.acked) == nullptr) {
			base = {};
		} else if (base.spacing > 0 && person.history.find(delivery.before) == nullptr) {
			base.spacing = 0;
		}
		const EncodedPerson &encoded = _encode_person(index, base, base == p_draft.usual);
		// The most urgent comes before all bodies.
		const std::size_t room = entry.people_count == 0 ? p_draft.room : p_room;
		if (encoded.size == 0 || p_draft.out.size + encoded.size > room) {
			if (encoded.size == 0) {
				_people_waiting.pop_back();
				continue;
			}
			return;
		}
		std::memcpy(&p_draft.out.bytes[p_draft.out.size], encoded.bytes.data(), encoded.size);
		p_draft.out.size += encoded.size;
		entry.people[entry.people_count++] = uint16_t(index);
		delivery.sent = _history.tick();
		delivery.is_lost = false;
		delivery.urgency = 0.0f;
		_people_waiting.pop_back();
	}
}

// Takes the most urgent bodies that are likely to fit out of those that wait, in the order of their ids.
std::size_t SnapshotEncoder::_choose_bodies(std::size_t p_room) {
	const std::size_t most = std::min(std::size_t(float(p_room) / _bytes_per_body), std::size_t(MAX_BODIES));
	const std::size_t count = std::min(most, _bodies_waiting.size());
	const auto begin = _bodies_waiting.end() - std::ptrdiff_t(count);
	std::nth_element(_bodies_waiting.begin(), begin, _bodies_waiting.end(),
			[](const Candidate &p_a, const Candidate &p_b) { return p_a.urgency < p_b.urgency; });
	_chosen.clear();
	for (auto one = begin; one != _bodies_waiting.end(); ++one) {
		_chosen.push_back(one->index);
	}
	_bodies_waiting.erase(begin, _bodies_waiting.end());
	std::sort(_chosen.begin(), _chosen.end(),
			[this](uint16_t p_a, uint16_t p_b) { return _history.bodies()[p_a]->id < _history.bodies()[p_b]->id; });
	return count;
}

void SnapshotEncoder::_write_bodies(ClientRecord &p_client, Draft &p_draft) {
	Datagram &out = p_draft.out;
	if (_bodies_waiting.empty() || out.size + BODY_MARGIN > p_draft.room ||
			_choose_bodies(p_draft.room - out.size - BODY_MARGIN) == 0) {
		return;
	}
	const std::size_t begin = out.size;
	RangeEncoder encoder(&out.bytes[begin], MAX_BYTES - begin);
	int last_id = -1;
	bool is_full = false;
	for (const uint16_t index : _chosen) {
		const std::size_t now = begin + encoder.written();
		is_full = is_full || now + BODY_MARGIN > p_draft.room || now + WORST_BODY > MAX_BYTES;
		if (is_full) {
			_bodies_waiting.push_back({ p_client.bodies[index].urgency, index });
			continue;
		}
		const WorldHistory::Body &body = *_history.bodies()[index];
		ClientRecord::BodyDelivery &delivery = p_client.bodies[index];
		const Baseline base = _baseline_of(delivery, false);
		const BodyState *known = base.age > 0 ? body.history.find(delivery.acked) : nullptr;
		if (last_id >= 0) {
			encoder.encode_bit(false, GOES_ON);
		}
		encode_count(encoder, uint32_t(int(body.id) - last_id - 1), 1);
		encoder.encode_bit(known == nullptr, HAS_BASE);
		if (known != nullptr) {
			encoder.encode_bits(uint32_t(base.age), AGE_BITS);
		}
		BodyCodec::encode(encoder, *body.history.find(_history.tick()), known, base.age, _history.rate());
		last_id = int(body.id);
		p_draft.entry.bodies[p_draft.entry.body_count++] = index;
		delivery.sent = _history.tick();
		delivery.is_lost = false;
		delivery.urgency = 0.0f;
		delivery.believed = body.now;
	}
	if (p_draft.entry.body_count == 0) {
		return;
	}
	encoder.encode_bit(true, GOES_ON);
	const std::size_t size = encoder.finish();
	// Those that did not fit are always the ones with the highest numbers: it may not happen often.
	const float each = float(size) / float(p_draft.entry.body_count);
	_bytes_per_body =
			is_full ? std::max(each, _bytes_per_body) : _bytes_per_body + (each - _bytes_per_body) * BODY_SIZE_MEMORY;
	out.size += size;
}

std::size_t SnapshotEncoder::encode(
		int p_client, int64_t p_now_usec, std::array<Datagram, MAX_DATAGRAMS> &r_datagrams) {
	ClientRecord *client = this->client(p_client);
	if (client == nullptr || _history.tick() == NEVER || client->last_tick == _history.tick()) {
		return 0;
	}
	client->follow(_history);
	client->allowance = std::min(client->allowance + client->bytes_per_tick,
			std::max(client->bytes_per_tick * _history.rate() / client->rate * MAX_SAVED, double(MAX_BYTES)));
	// Evenly, also where the rates do not divide each other.
	const auto snapshots = [&](uint32_t p_tick) {
		return uint64_t(p_tick) * uint64_t(client->rate) / uint64_t(_history.rate());
	};
	const bool is_due = client->last_tick == NEVER || snapshots(_history.tick()) != snapshots(client->last_tick);
	if (!is_due && !_history.has_jolts()) {
		return 0;
	}
	_collect_people(*client, !is_due);
	_collect_bodies(*client, !is_due);
	client->last_tick = is_due ? _history.tick() : client->last_tick;
	const bool is_silent = _people_waiting.empty() && _bodies_waiting.empty();
	const uint32_t silence = uint32_t(_history.rate()) / SILENCES_PER_SECOND;
	if (is_silent && client->sent_tick != NEVER && _history.tick() - client->sent_tick < silence) {
		return 0;
	}
	std::size_t count = 0;
	while (count < MAX_DATAGRAMS && (count == 0 || !_people_waiting.empty() || !_bodies_waiting.empty())) {
		const double room = std::min(client->allowance - double(TRANSPORT_BYTES), double(MAX_BYTES));
		if (room < double(WORST_BODY)) {
			break;
		}
		Draft draft{ r_datagrams[count], client->begin_datagram(_history.tick()), _usual_baseline(*client),
			std::size_t(room) };
		_write_header(*client, draft, p_now_usec);
		const double needed = std::min(double(_bytes_per_body) * double(_bodies_waiting.size()), room * BODIES_SHARE);
		_write_people(*client, draft, std::size_t(room - needed));
		// A person who does not fit is saved up for: bodies would always leave too little.
		if (draft.entry.people_count > 0 || _people_waiting.empty()) {
			_write_bodies(*client, draft);
		}
		draft.out.bytes[0] |= uint8_t(uint32_t(draft.entry.people_count) << 4U);
		const bool is_empty = draft.entry.people_count == 0 && draft.entry.body_count == 0;
		if (is_empty && !is_silent) {
			client->cancel_datagram(); // It saves up for who is waiting.
			break;
		}
		client->allowance -= double(draft.out.size + TRANSPORT_BYTES);
		client->sent_tick = _history.tick();
		client->stats.datagrams++;
		client->stats.bytes += draft.out.size + TRANSPORT_BYTES;
		count++;
		if (is_empty) {
			break;
		}
	}
	return count;
}

} // namespace wire
