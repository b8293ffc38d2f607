// SPDX-License-Identifier: MIT
#pragma once

#include "bus/data_item.hpp"

namespace xbus {

/// Calls `p_visit(const Item &)` for each item of an MTData2 message (0x36). False if the items do not fill
/// the data exactly; those before the fault have been visited.
template <class V>
bool visit_items(const uint8_t *p_data, std::size_t p_size, V &&p_visit) {
	constexpr std::size_t HEAD = 3;
	std::size_t at = 0;
	while (p_size - at >= HEAD) {
		const Item item = { read_u16(p_data + at), p_data + at + HEAD, p_data[at + 2] };
		if (p_size - at - HEAD < item.size) {
			return false;
		}
		p_visit(item);
		at += HEAD + item.size;
	}
	return at == p_size;
}

/// How reading a message went.
struct ItemReport {
	/// Whether the items fill the message exactly; if not, the sample is worth nothing.
	bool whole = false;
	uint8_t decoded = 0;
	/// Items of types that are not known: skipped.
	uint8_t unknown = 0;
	/// Items of known types with a length that they cannot have: skipped.
	uint8_t misfits = 0;

	bool is_clean() const { return whole && unknown == 0 && misfits == 0; }
};

/// Decodes an MTData2 message. The sample's `present` begins anew; `bus_id` is left to the caller.
ItemReport decode_mt_data2(const uint8_t *p_data, std::size_t p_size, Sample &r_sample);

/// Writes the data of an MTData2 message with these items of the sample. Returns its size; 0 if there is no
/// room or an identifier that a sample does not hold.
std::size_t write_mt_data2(
		const uint16_t *p_ids, std::size_t p_count, const Sample &p_sample, uint8_t *r_bytes, std::size_t p_room);

} // namespace xbus
