// SPDX-License-Identifier: MIT
#include "replication/bodies_writer.hpp"

#include "replication/body_codec.hpp"
#include "replication/entry_coding.hpp"

#include <algorithm>
#include <cmath>

namespace wire {

namespace {

// Of what is out of sight only a coarse position is needed: so many times the tolerance.
constexpr float HIDDEN_TOLERANCE = 8.0f;
// Errors beyond so many tolerances are all alike.
constexpr float MAX_ERROR = 20.0f;
// Bytes that a body usually takes at most, with the end of the coder.
constexpr std::size_t BODY_MARGIN = 16;
constexpr float BODY_SIZE_MEMORY = 0.02f;

} // namespace

float BodiesWriter::find_error(const ClientRecord::BodyDelivery &p_delivery, const WorldHistory::Body &p_body) const {
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

void BodiesWriter::collect(ClientRecord &p_client, bool p_jolts_only) {
	_waiting.clear();
	for (std::size_t i = 0; i < p_client.bodies.size(); i++) {
		const WorldHistory::Body &body = *_history.bodies()[i];
		ClientRecord::BodyDelivery &delivery = p_client.bodies[i];
		if (!body.is_there || (p_jolts_only && !body.jolted) || !p_client.knows(body.table_version) ||
				body.history.find(_history.tick()) == nullptr) {
			continue;
		}
		const float weight = p_client.has_viewpoint && !p_client.is_recorder
				? _interest.weight(p_client.viewpoint, body.now.position)
				: 1.0f;
		const bool is_wrong = delivery.sent == NEVER || delivery.is_lost || body.jolted ||
				body.now.at_rest != delivery.believed.at_rest;
		const bool ages = !body.now.at_rest && _history.tick() - delivery.sent >= uint32_t(_history.rate());
		const float error = is_wrong ? MAX_ERROR : std::min(find_error(delivery, body) / TOLERANCE_M, MAX_ERROR);
		const bool is_recorded = p_client.is_recorder && (!body.now.at_rest || error > 0.0f);
		if (!is_wrong && !ages && !is_recorded && error < (weight < Interest::FAR ? HIDDEN_TOLERANCE : 1.0f)) {
			continue;
		}
		delivery.urgency = std::min(delivery.urgency + weight * error, MAX_URGENCY);
		_waiting.add(delivery.urgency + (is_wrong ? MAX_URGENCY : 0.0f), i);
	}
}

// Takes the most urgent bodies that are likely to fit out of those that wait, in the order of their ids.
std::size_t BodiesWriter::choose(std::size_t p_room) {
	const std::size_t most = std::min(std::size_t(float(p_room) / _bytes_each), std::size_t(MAX_BODIES));
	const std::size_t count = std::min(most, _waiting.size());
	_waiting.take(count, _chosen);
	std::sort(_chosen.begin(), _chosen.end(), [this](uint16_t p_a, uint16_t p_b) {
		return thing_number(_history.bodies()[p_a]->id) < thing_number(_history.bodies()[p_b]->id);
	});
	return count;
}

void BodiesWriter::write(ClientRecord &p_client, Draft &p_draft, std::size_t p_room) {
	Datagram &out = p_draft.out;
	if (_waiting.is_empty() || out.size + BODY_MARGIN > p_room || choose(p_room - out.size - BODY_MARGIN) == 0) {
		return;
	}
	const std::size_t begin = out.size;
	RangeEncoder encoder(&out.bytes[begin], MAX_BYTES - begin);
	int last_id = -1;
	bool is_full = false;
	for (const uint16_t index : _chosen) {
		const std::size_t now = begin + encoder.written();
		is_full = is_full || now + BODY_MARGIN > p_room || now + WORST_BODY > MAX_BYTES;
		if (is_full) {
			_waiting.add(p_client.bodies[index].urgency, index);
			continue;
		}
		const WorldHistory::Body &body = *_history.bodies()[index];
		ClientRecord::BodyDelivery &delivery = p_client.bodies[index];
		const Baseline base = delivery.find_baseline(_history.tick(), false);
		const BodyState *known = base.age > 0 ? body.history.find(delivery.acked) : nullptr;
		if (last_id >= 0) {
			encoder.encode_bit(false, GOES_ON);
		}
		encode_count(encoder, uint32_t(int(thing_number(body.id)) - last_id - 1), 1);
		encoder.encode_bit(known == nullptr, HAS_BASE);
		if (known != nullptr) {
			encoder.encode_bits(uint32_t(base.age), AGE_BITS);
		}
		BodyCodec::encode(encoder, *body.history.find(_history.tick()), known, base.age, _history.rate());
		last_id = int(thing_number(body.id));
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
	_bytes_each = is_full ? std::max(each, _bytes_each) : _bytes_each + (each - _bytes_each) * BODY_SIZE_MEMORY;
	out.size += size;
	p_draft.flags |= HAS_BODIES;
}

} // namespace wire
