// SPDX-License-Identifier: MIT
#include "mvn/collector.hpp"

#include <algorithm>
#include <functional>
#include <string_view>

namespace mvn {

namespace {

/// A sender that is silent for so long has given its characters up, µs.
constexpr uint64_t SENDER_USEC = 2000000;
/// Bytes of a sample in all its parts.
constexpr std::size_t MAX_BYTES = 65536;
/// A counter that is further back than so many has begun anew.
constexpr uint32_t MAX_LATE = 240;
constexpr uint32_t MAX_STEP = 2000;
/// Without a sample for so long a counter may begin anew anywhere, µs.
constexpr uint64_t ANEW_USEC = 500000;
constexpr uint64_t METER_USEC = 1000000;
/// Partial samples that wait at most.
constexpr std::size_t MAX_PARTIAL = 8;

uint64_t hash_of(const uint8_t *p_bytes, std::size_t p_size) {
	const auto *text = reinterpret_cast<const char *>(p_bytes);
	return std::hash<std::string_view>()(std::string_view(text, p_size));
}

} // namespace

Outcome Collector::take(const uint8_t *p_bytes, std::size_t p_size, uint64_t p_sender, uint64_t p_now_usec) {
	++_datagrams;
	const Fault fault = read_header(p_bytes, p_size, _header);
	if (fault != Fault::NONE) {
		return refuse(fault);
	}
	auto found = _characters.find(_header.character);
	if (found == _characters.end()) {
		if (_characters.size() >= std::size_t(MAX_CHARACTERS)) {
			return Outcome::CROWDED;
		}
		found = _characters.try_emplace(_header.character).first;
		found->second.sender = p_sender;
	}
	Character &character = found->second;
	if (character.sender != p_sender) {
		if (p_now_usec < character.statistics.newest_usec + SENDER_USEC) {
			++character.statistics.foreign;
			return Outcome::FOREIGN;
		}
		character = Character();
		character.sender = p_sender;
	}
	character.statistics.newest_usec = p_now_usec;
	return add(character, p_bytes + HEADER_SIZE, p_size - HEADER_SIZE, p_now_usec);
}

Outcome Collector::refuse(Fault p_fault) {
	_fault = p_fault;
	++_refused[std::size_t(p_fault)];
	return Outcome::REFUSED;
}

Outcome Collector::add(Character &p_character, const uint8_t *p_payload, std::size_t p_size, uint64_t p_now_usec) {
	Slot &slot = p_character.slots[std::size_t(_header.type)];
	const uint64_t hash = hash_of(p_payload, p_size);
	// A counter that goes back when nothing has come for a while belongs to a sender that began anew.
	if (slot.has_whole && slot.newest_whole - _header.sample < MAX_LATE && p_now_usec < slot.whole_usec + ANEW_USEC) {
		return count_late(p_character, slot, hash);
	}
	Pending &pending = pending_of(p_character, slot);
	const Outcome stored = store_part(pending, p_payload, p_size);
	if (stored == Outcome::LATE) {
		return count_late(p_character, slot, hash);
	}
	print_of(slot, _header) = { _header.sample, _header.part, hash, true };
	if (stored != Outcome::PART || !is_complete(pending)) {
		return stored;
	}
	pending.is_begun = false;
	sort_parts(pending);
	const Fault fault = read_parts(pending, pending.part_count, slot.content);
	if (fault != Fault::NONE) {
		return refuse(fault);
	}
	for (Pending &other : slot.pending) {
		// Older ones would come too late now.
		if (other.is_begun && _header.sample - other.sample < MAX_LATE) {
			give_up(p_character, slot, other);
		}
	}
	slot.has_whole = true;
	slot.newest_whole = _header.sample;
	slot.whole_usec = p_now_usec;
	_content = &slot.content;
	++p_character.statistics.samples;
	note_sample(p_character, _header, p_now_usec);
	return Outcome::SAMPLE;
}

/// Where the parts of the present sample are kept; a new one replaces the oldest.
Collector::Pending &Collector::pending_of(Character &p_character, Slot &p_slot) {
	Pending *slot = &p_slot.pending[0];
	for (Pending &pending : p_slot.pending) {
		if (pending.is_begun && pending.sample == _header.sample) {
			return pending;
		}
		if (slot->is_begun && (!pending.is_begun || _header.sample - pending.sample > _header.sample - slot->sample)) {
			slot = &pending;
		}
	}
	if (slot->is_begun) {
		give_up(p_character, p_slot, *slot);
	}
	slot->is_begun = true;
	slot->sample = _header.sample;
	slot->part_count = 0;
	slot->bytes = 0;
	return *slot;
}

Collector::Print &Collector::print_of(Slot &p_slot, const Header &p_header) {
	return p_slot.prints[(p_header.sample * 5U + p_header.part) % p_slot.prints.size()];
}

Outcome Collector::count_late(Character &p_character, Slot &p_slot, uint64_t p_hash) {
	++p_character.statistics.late;
	const Print &print = print_of(p_slot, _header);
	const bool is_same_datagram = print.is_known && print.sample == _header.sample && print.part == _header.part;
	p_character.statistics.conflicting += is_same_datagram && print.hash != p_hash ? 1U : 0U;
	return Outcome::LATE;
}

/// A part of this sample will not come any more: of a pose the body may have come all the same.
void Collector::give_up(Character &p_character, Slot &p_slot, Pending &p_pending) {
	p_pending.is_begun = false;
	++p_character.statistics.incomplete;
	sort_parts(p_pending);
	std::size_t whole = 0;
	while (whole < p_pending.part_count && std::size_t(p_pending.parts[whole].header.part) == whole) {
		++whole;
	}
	const bool is_late = p_slot.has_whole && p_slot.newest_whole - p_pending.sample < MAX_LATE;
	if (whole == 0 || is_late || !is_motion(p_pending.parts[0].header.type)) {
		return;
	}
	Content content;
	const bool is_read = read_parts(p_pending, whole, content) == Fault::NONE;
	const std::size_t body = content.header.body_segments != 0 ? content.header.body_segments : BODY_SEGMENTS;
	if (!is_read || content.poses.size() < body || _partial.size() >= MAX_PARTIAL) {
		return;
	}
	// Props and fingers count only where all of them are there.
	content.poses.resize(body);
	content.header.props = content.header.fingers = 0;
	p_slot.has_whole = true;
	p_slot.newest_whole = p_pending.sample;
	p_slot.whole_usec = p_character.statistics.newest_usec;
	++p_character.statistics.samples;
	++p_character.statistics.partial;
	note_sample(p_character, content.header, p_slot.whole_usec);
	_partial.push_back(std::move(content));
}

std::vector<Content> Collector::take_partial() {
	std::vector<Content> partial;
	partial.swap(_partial);
	return partial;
}

Outcome Collector::store_part(Pending &p_pending, const uint8_t *p_payload, std::size_t p_size) {
	for (std::size_t at = 0; at < p_pending.part_count; ++at) {
		const Header &known = p_pending.parts[at].header;
		if (known.part == _header.part) {
			return Outcome::LATE;
		}
		// Two ends, or something beyond the end: not one sample.
		if ((known.is_last && (_header.is_last || _header.part > known.part)) ||
				(_header.is_last && known.part > _header.part)) {
			p_pending.is_begun = false;
			return refuse(Fault::BAD_PARTS);
		}
	}
	p_pending.bytes += p_size;
	if (p_pending.bytes > MAX_BYTES) {
		p_pending.is_begun = false;
		return refuse(Fault::TOO_MANY);
	}
	if (p_pending.part_count == p_pending.parts.size()) {
		p_pending.parts.emplace_back();
	}
	Part &part = p_pending.parts[p_pending.part_count++];
	part.header = _header;
	part.payload.assign(p_payload, p_payload + p_size);
	return Outcome::PART;
}

bool Collector::is_complete(const Pending &p_pending) {
	for (std::size_t at = 0; at < p_pending.part_count; ++at) {
		if (p_pending.parts[at].header.is_last) {
			return p_pending.part_count == std::size_t(p_pending.parts[at].header.part) + 1;
		}
	}
	return false;
}

void Collector::sort_parts(Pending &p_pending) {
	std::sort(p_pending.parts.begin(), p_pending.parts.begin() + std::ptrdiff_t(p_pending.part_count),
			[](const Part &p_a, const Part &p_b) { return p_a.header.part < p_b.header.part; });
}

/// Reads the first parts, so many, of a sample whose parts are sorted.
Fault Collector::read_parts(const Pending &p_pending, std::size_t p_count, Content &r_content) {
	clear(r_content);
	r_content.header = p_pending.parts[0].header;
	r_content.header.is_last = true;
	for (std::size_t at = 0; at < p_count; ++at) {
		const Part &part = p_pending.parts[at];
		const Fault fault = read_payload(part.header, part.payload.data(), part.payload.size(), r_content);
		if (fault != Fault::NONE) {
			return fault;
		}
	}
	return Fault::NONE;
}

/// Rate and loss are those of the type that comes most often: of one pose.
void Collector::note_sample(Character &p_character, const Header &p_header, uint64_t p_now_usec) {
	if (!is_motion(p_header.type)) {
		return;
	}
	if (p_header.type != p_character.leader && p_now_usec < p_character.leader_usec + METER_USEC &&
			p_character.leader_usec != 0) {
		return;
	}
	p_character.has_last = p_character.has_last && p_header.type == p_character.leader;
	p_character.leader = p_header.type;
	p_character.leader_usec = p_now_usec;
	if (p_character.has_last) {
		const uint32_t gap = p_header.sample - p_character.last_sample;
		if (gap == 0 || gap > MAX_STEP) {
			p_character.step = 0; // Begun anew.
			++p_character.statistics.jumps;
		} else if (p_character.step == 0 || gap < p_character.step) {
			p_character.step = gap;
		} else {
			p_character.statistics.lost += gap / p_character.step - 1;
		}
	}
	p_character.last_sample = p_header.sample;
	p_character.has_last = true;
	const uint64_t span = p_now_usec - p_character.metered_usec;
	if (p_character.metered_usec == 0 || span > 3 * METER_USEC) {
		p_character.metered_usec = p_now_usec;
		p_character.metered = 0;
		return;
	}
	++p_character.metered;
	if (span >= METER_USEC) {
		p_character.statistics.rate_hz = p_character.metered * 1e6 / double(span);
		p_character.metered_usec = p_now_usec;
		p_character.metered = 0;
	}
}

std::vector<std::pair<int, CharacterStatistics>> Collector::characters() const {
	std::vector<std::pair<int, CharacterStatistics>> found;
	found.reserve(_characters.size());
	for (const auto &[number, character] : _characters) {
		found.emplace_back(number, character.statistics);
	}
	return found;
}

CharacterStatistics Collector::statistics(int p_character) const {
	const auto found = _characters.find(p_character);
	return found != _characters.end() ? found->second.statistics : CharacterStatistics();
}

void Collector::forget_silent(uint64_t p_since_usec) {
	for (auto at = _characters.begin(); at != _characters.end();) {
		at = at->second.statistics.newest_usec < p_since_usec ? _characters.erase(at) : std::next(at);
	}
}

void Collector::clear(Content &p_content) {
	p_content.poses.clear();
	p_content.joints.clear();
	p_content.motions.clear();
	p_content.origins.clear();
	p_content.points.clear();
	p_content.tags.clear();
	p_content.time_code.clear();
}

} // namespace mvn
