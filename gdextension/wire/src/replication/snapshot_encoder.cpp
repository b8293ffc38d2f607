// SPDX-License-Identifier: MIT
#include "snapshot_encoder.hpp"

#include "body_codec.hpp"
#include "entry_coding.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace wire {

namespace {

// Share of a client's bytes that people leave to bodies that wait, if these need as much.
constexpr double BODIES_SHARE = 0.6;
// Urgency at which somebody out of sight is told of after all.
constexpr float HIDDEN_URGENCY = 0.75f;
// Of what is out of sight only a coarse place is needed: so many times the tolerance.
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
// With nothing to tell, a datagram keeps the clocks in step every half second.
constexpr uint32_t SILENCES_PER_SECOND = 2;
constexpr float BODY_SIZE_MEMORY = 0.02f;

} // namespace

SnapshotEncoder::SnapshotEncoder(const Skeleton &p_skeleton, double p_max_error_deg, int p_tick_rate) :
		codec(p_skeleton, PersonLattice::resolution_for(p_max_error_deg)),
		history(p_skeleton, PersonLattice(PersonLattice::resolution_for(p_max_error_deg)), p_tick_rate) {}

void SnapshotEncoder::add_client(int p_client, int p_snapshots_per_second, double p_bits_per_second) {
	const int rate =
			std::clamp(p_snapshots_per_second <= 0 ? history.rate() : p_snapshots_per_second, 1, history.rate());
	// Written so that NaN counts as the least.
	const double bits = p_bits_per_second > 1000.0 ? p_bits_per_second : 1000.0;
	clients[p_client] = std::make_unique<ClientRecord>(rate, bits / 8.0 / history.rate());
}

ClientRecord *SnapshotEncoder::client(int p_client) {
	const auto found = clients.find(p_client);
	return found == clients.end() ? nullptr : found->second.get();
}

void SnapshotEncoder::set_mark(const Mark &p_mark) {
	for (std::size_t i = 0; i < history.people().size(); i++) {
		if (history.people()[i]->is_there && history.people()[i]->id == p_mark.person) {
			marks.resize(std::max(marks.size(), i + 1));
			mark_ticks.resize(marks.size(), NEVER);
			marks[i] = p_mark;
			mark_ticks[i] = history.tick();
		}
	}
}

void SnapshotEncoder::collect_people(ClientRecord &p_client, bool p_jolts_only) {
	people_waiting.clear();
	for (std::size_t i = 0; i < p_client.people.size(); i++) {
		const WorldHistory::Person &person = *history.people()[i];
		Delivery &delivery = p_client.people[i];
		if (!person.is_there || person.trail.find(history.tick()) == nullptr) {
			continue;
		}
		const bool own = int(person.id) == p_client.own_person;
		const float weight =
				own || !p_client.has_viewpoint ? 1.0f : visibility.weight(p_client.viewpoint, person.place);
		delivery.urgency += weight;
		const bool is_due = weight >= Interest::FAR || delivery.urgency >= HIDDEN_URGENCY || delivery.sent == NEVER;
		if (p_jolts_only ? person.jolted : is_due) {
			people_waiting.push_back({ delivery.urgency + (person.jolted ? URGENT : 0.0f), uint16_t(i) });
		}
	}
	std::sort(people_waiting.begin(), people_waiting.end(),
			[](const Candidate &p_a, const Candidate &p_b) { return p_a.urgency < p_b.urgency; });
}

float SnapshotEncoder::body_error(
		const ClientRecord::BodyDelivery &p_delivery, const WorldHistory::Body &p_body) const {
	const BodyUpdate &believed = p_delivery.believed;
	if (p_body.now.at_rest && believed.at_rest && !p_delivery.is_lost) {
		// Usually nothing has happened at all.
		const Vec3 way = p_body.now.position - believed.position;
		if (way.dot(way) == 0.0f) {
			return 0.0f;
		}
	}
	const float seconds = float(history.tick() - believed.tick) / float(history.rate());
	const BodyPlace place = predict(believed, seconds);
	const float cosine = std::min(1.0f, std::fabs(place.orientation.dot(p_body.now.orientation)));
	// The chord stands for the arc: 2 sqrt(2 - 2 cos(a/2)).
	const float angle = 2.0f * std::sqrt(2.0f - 2.0f * cosine);
	return (p_body.now.position - place.position).length() + LEVER_M * angle;
}

void SnapshotEncoder::collect_bodies(ClientRecord &p_client, bool p_jolts_only) {
	bodies_waiting.clear();
	for (std::size_t i = 0; i < p_client.bodies.size(); i++) {
		const WorldHistory::Body &body = *history.bodies()[i];
		ClientRecord::BodyDelivery &delivery = p_client.bodies[i];
		if (!body.is_there || (p_jolts_only && !body.jolted) || body.trail.find(history.tick()) == nullptr) {
			continue;
		}
		const float weight = p_client.has_viewpoint ? visibility.weight(p_client.viewpoint, body.now.position) : 1.0f;
		const bool is_wrong = delivery.sent == NEVER || delivery.is_lost || body.jolted ||
				body.now.at_rest != delivery.believed.at_rest;
		const bool ages = !body.now.at_rest && history.tick() - delivery.sent >= uint32_t(history.rate());
		const float error = is_wrong ? MAX_ERROR : std::min(body_error(delivery, body) / TOLERANCE_M, MAX_ERROR);
		if (!is_wrong && !ages && error < (weight < Interest::FAR ? HIDDEN_TOLERANCE : 1.0f)) {
			continue;
		}
		delivery.urgency = std::min(delivery.urgency + weight * error, URGENT);
		bodies_waiting.push_back({ delivery.urgency + (is_wrong ? URGENT : 0.0f), uint16_t(i) });
	}
}

Baseline SnapshotEncoder::baseline_of(const Delivery &p_delivery, bool p_has_before) const {
	Baseline base;
	const uint32_t tick = history.tick();
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

Baseline SnapshotEncoder::usual_baseline(const ClientRecord &p_client) const {
	// That of the most urgent: mostly all have the same.
	if (people_waiting.empty()) {
		return {};
	}
	const Baseline base = baseline_of(p_client.people[people_waiting.back().place], true);
	return base.age <= Baseline::MAX_SHORT_AGE ? base : Baseline{};
}

void SnapshotEncoder::write_header(ClientRecord &p_client, Draft &p_draft, int64_t p_now_usec) {
	Datagram &out = p_draft.out;
	// After a silence the client may be so far behind that low bytes of ticks and numbers mislead it.
	const bool is_silent = p_client.heard_tick == NEVER ||
			history.tick() - p_client.heard_tick > uint32_t(history.rate()) / SILENT_PART;
	const bool is_key = is_silent || p_client.key_in == 0;
	p_client.key_in = is_key ? std::size_t(p_client.rate) : p_client.key_in - 1;
	out.bytes[0] = uint8_t(is_key ? Kind::KEY : Kind::SNAPSHOT);
	out.bytes[1] = p_draft.entry.number;
	out.size = 2;
	const int tick_bytes = is_key ? 4 : 1;
	put_number(&out.bytes[out.size], history.tick(), tick_bytes);
	out.size += std::size_t(tick_bytes);
	if (is_key) {
		out.bytes[out.size++] = uint8_t(history.rate());
	}
	out.bytes[out.size++] = p_draft.usual.pack();
	if (write_mark(p_client, p_draft, p_now_usec)) {
		out.bytes[0] |= HAS_MARKS;
	}
}

bool SnapshotEncoder::write_mark(ClientRecord &p_client, Draft &p_draft, int64_t p_now_usec) {
	const uint32_t tick = history.tick();
	const uint32_t period = p_client.wants_marks ? 1 : uint32_t(std::max(1, history.rate() / MARKS_PER_SECOND));
	if (marks.empty() || (p_client.mark_tick != NEVER && tick - p_client.mark_tick < period)) {
		return false;
	}
	for (std::size_t i = 0; i < marks.size(); i++) {
		const std::size_t place = (p_client.marked + 1 + i) % marks.size();
		if (mark_ticks[place] != tick || !history.people()[place]->is_there) {
			continue;
		}
		Mark mark = marks[place];
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
		p_client.marked = place;
		p_client.mark_tick = tick;
		return true;
	}
	return false;
}

const SnapshotEncoder::Blob &SnapshotEncoder::person_blob(
		std::size_t p_place, const Baseline &p_base, bool p_is_usual) {
	if (blobs.size() <= p_place) {
		blobs.resize(p_place + 1);
		blob_turns.resize(p_place + 1, 0);
	}
	const uint32_t tick = history.tick();
	for (const Blob &blob : blobs[p_place]) {
		if (blob.tick == tick && blob.base == p_base && blob.is_usual == p_is_usual) {
			return blob;
		}
	}
	Blob &blob = blobs[p_place][blob_turns[p_place]++ % BLOBS];
	const WorldHistory::Person &person = *history.people()[p_place];
	blob.tick = tick;
	blob.base = p_base;
	blob.is_usual = p_is_usual;
	RangeEncoder encoder(blob.bytes.data(), blob.bytes.size());
	encode_count(encoder, person.id, 2);
	encode_baseline(encoder, p_base, p_is_usual);
	const PersonState *base = p_base.age > 0 ? person.trail.find(tick - uint32_t(p_base.age)) : nullptr;
	const int older = p_base.age + p_base.spacing;
	const PersonState *before = p_base.spacing > 0 ? person.trail.find(tick - uint32_t(older)) : nullptr;
	codec.encode(encoder, *person.trail.find(tick), base, before, p_base.age, older);
	blob.size = encoder.finish();
	return blob;
}

void SnapshotEncoder::write_people(ClientRecord &p_client, Draft &p_draft, std::size_t p_room) {
	SentDatagram &entry = p_draft.entry;
	while (!people_waiting.empty() && entry.people_count < MAX_PEOPLE) {
		const std::size_t place = people_waiting.back().place;
		const WorldHistory::Person &person = *history.people()[place];
		Delivery &delivery = p_client.people[place];
		Baseline base = baseline_of(delivery, true);
		if (base.age > 0 && person.trail.find(delivery.acked) == nullptr) {
			base = {};
		} else if (base.spacing > 0 && person.trail.find(delivery.before) == nullptr) {
			base.spacing = 0;
		}
		const Blob &blob = person_blob(place, base, base == p_draft.usual);
		// The most urgent comes before all bodies.
		const std::size_t room = entry.people_count == 0 ? p_draft.room : p_room;
		if (blob.size == 0 || p_draft.out.size + blob.size > room) {
			if (blob.size == 0) {
				people_waiting.pop_back();
				continue;
			}
			return;
		}
		std::memcpy(&p_draft.out.bytes[p_draft.out.size], blob.bytes.data(), blob.size);
		p_draft.out.size += blob.size;
		entry.people[entry.people_count++] = uint16_t(place);
		delivery.sent = history.tick();
		delivery.is_lost = false;
		delivery.urgency = 0.0f;
		people_waiting.pop_back();
	}
}

// Takes the most urgent bodies that are likely to fit out of those that wait, in the order of their ids.
std::size_t SnapshotEncoder::choose_bodies(std::size_t p_room) {
	const std::size_t most = std::min(std::size_t(float(p_room) / bytes_per_body), std::size_t(MAX_BODIES));
	const std::size_t count = std::min(most, bodies_waiting.size());
	const auto begin = bodies_waiting.end() - std::ptrdiff_t(count);
	std::nth_element(bodies_waiting.begin(), begin, bodies_waiting.end(),
			[](const Candidate &p_a, const Candidate &p_b) { return p_a.urgency < p_b.urgency; });
	chosen.clear();
	for (auto one = begin; one != bodies_waiting.end(); ++one) {
		chosen.push_back(one->place);
	}
	bodies_waiting.erase(begin, bodies_waiting.end());
	std::sort(chosen.begin(), chosen.end(),
			[this](uint16_t p_a, uint16_t p_b) { return history.bodies()[p_a]->id < history.bodies()[p_b]->id; });
	return count;
}

void SnapshotEncoder::write_bodies(ClientRecord &p_client, Draft &p_draft) {
	Datagram &out = p_draft.out;
	if (bodies_waiting.empty() || out.size + BODY_MARGIN > p_draft.room ||
			choose_bodies(p_draft.room - out.size - BODY_MARGIN) == 0) {
		return;
	}
	const std::size_t begin = out.size;
	RangeEncoder encoder(&out.bytes[begin], MAX_BYTES - begin);
	int last_id = -1;
	bool is_full = false;
	for (const uint16_t place : chosen) {
		const std::size_t now = begin + encoder.written();
		is_full = is_full || now + BODY_MARGIN > p_draft.room || now + WORST_BODY > MAX_BYTES;
		if (is_full) {
			bodies_waiting.push_back({ p_client.bodies[place].urgency, place });
			continue;
		}
		const WorldHistory::Body &body = *history.bodies()[place];
		ClientRecord::BodyDelivery &delivery = p_client.bodies[place];
		const Baseline base = baseline_of(delivery, false);
		const BodyState *known = base.age > 0 ? body.trail.find(delivery.acked) : nullptr;
		if (last_id >= 0) {
			encoder.encode_bit(false, GOES_ON);
		}
		encode_count(encoder, uint32_t(int(body.id) - last_id - 1), 1);
		encoder.encode_bit(known == nullptr, HAS_BASE);
		if (known != nullptr) {
			encoder.encode_bits(uint32_t(base.age), AGE_BITS);
		}
		BodyCodec::encode(encoder, *body.trail.find(history.tick()), known, base.age, history.rate());
		last_id = int(body.id);
		p_draft.entry.bodies[p_draft.entry.body_count++] = place;
		delivery.sent = history.tick();
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
	bytes_per_body =
			is_full ? std::max(each, bytes_per_body) : bytes_per_body + (each - bytes_per_body) * BODY_SIZE_MEMORY;
	out.size += size;
}

std::size_t SnapshotEncoder::encode(
		int p_client, int64_t p_now_usec, std::array<Datagram, MAX_DATAGRAMS> &r_datagrams) {
	ClientRecord *client = this->client(p_client);
	if (client == nullptr || history.tick() == NEVER || client->last_tick == history.tick()) {
		return 0;
	}
	client->follow(history);
	client->allowance = std::min(client->allowance + client->bytes_per_tick,
			std::max(client->bytes_per_tick * history.rate() / client->rate * MAX_SAVED, double(MAX_BYTES)));
	// Evenly, also where the rates do not divide each other.
	const auto snapshots = [&](uint32_t p_tick) {
		return uint64_t(p_tick) * uint64_t(client->rate) / uint64_t(history.rate());
	};
	const bool is_due = client->last_tick == NEVER || snapshots(history.tick()) != snapshots(client->last_tick);
	if (!is_due && !history.has_jolts()) {
		return 0;
	}
	collect_people(*client, !is_due);
	collect_bodies(*client, !is_due);
	client->last_tick = is_due ? history.tick() : client->last_tick;
	const bool is_silent = people_waiting.empty() && bodies_waiting.empty();
	const uint32_t silence = uint32_t(history.rate()) / SILENCES_PER_SECOND;
	if (is_silent && client->sent_tick != NEVER && history.tick() - client->sent_tick < silence) {
		return 0;
	}
	std::size_t count = 0;
	while (count < MAX_DATAGRAMS && (count == 0 || !people_waiting.empty() || !bodies_waiting.empty())) {
		const double room = std::min(client->allowance - double(TRANSPORT_BYTES), double(MAX_BYTES));
		if (room < double(WORST_BODY)) {
			break;
		}
		Draft draft{ r_datagrams[count], client->begin_datagram(history.tick()), usual_baseline(*client),
			std::size_t(room) };
		write_header(*client, draft, p_now_usec);
		const double needed = std::min(double(bytes_per_body) * double(bodies_waiting.size()), room * BODIES_SHARE);
		write_people(*client, draft, std::size_t(room - needed));
		// A person who does not fit is saved up for: bodies would always leave too little.
		if (draft.entry.people_count > 0 || people_waiting.empty()) {
			write_bodies(*client, draft);
		}
		draft.out.bytes[0] |= uint8_t(uint32_t(draft.entry.people_count) << 4U);
		const bool is_empty = draft.entry.people_count == 0 && draft.entry.body_count == 0;
		if (is_empty && !is_silent) {
			client->cancel_datagram(); // It saves up for who is waiting.
			break;
		}
		client->allowance -= double(draft.out.size + TRANSPORT_BYTES);
		client->sent_tick = history.tick();
		client->figures.datagrams++;
		client->figures.bytes += draft.out.size + TRANSPORT_BYTES;
		count++;
		if (is_empty) {
			break;
		}
	}
	return count;
}

} // namespace wire
