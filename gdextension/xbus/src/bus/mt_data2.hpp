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
	/// Items of types that are not read: skipped.
	uint8_t unknown = 0;
	/// Items of known types with a length that they cannot have: skipped.
	uint8_t misfits = 0;

	bool is_clean() const { return whole && unknown == 0 && misfits == 0; }
	void note(ItemFate p_fate) {
		uint8_t &counter = p_fate == ItemFate::DECODED ? decoded : (p_fate == ItemFate::MISFIT ? misfits : unknown);
		counter = counter < 0xFF ? uint8_t(counter + 1) : counter;
	}
};

/// Decodes an MTData2 message into a sample of any kind that `decode_item` takes. What is present begins anew;
/// `bus_id` is left to the caller.
template <class S>
ItemReport decode_mt_data2(const uint8_t *p_data, std::size_t p_size, S &r_sample) {
	ItemReport report;
	r_sample.clear();
	r_sample.axes = Axes::EAST_NORTH_UP;
	report.whole = visit_items(p_data, p_size, [&](const Item &p_item) { report.note(decode_item(p_item, r_sample)); });
	return report;
}

} // namespace xbus
