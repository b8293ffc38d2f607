// SPDX-License-Identifier: MIT
#include "bus/mt_data2.hpp"

#include <array>

namespace xbus {

namespace {

// Counters of items, not of messages: they stop at their end.
void count(uint8_t &r_counter) {
	r_counter = r_counter < 0xFF ? uint8_t(r_counter + 1) : r_counter;
}

} // namespace

ItemReport decode_mt_data2(const uint8_t *p_data, std::size_t p_size, Sample &r_sample) {
	ItemReport report;
	r_sample.present = 0;
	r_sample.axes = Axes::EAST_NORTH_UP;
	report.whole = visit_items(p_data, p_size, [&](const Item &p_item) {
		if (decode_item(p_item, r_sample)) {
			count(report.decoded);
		} else if (item_type(p_item.id).is_known()) {
			count(report.misfits);
		} else {
			count(report.unknown);
		}
	});
	return report;
}

std::size_t write_mt_data2(
		const uint16_t *p_ids, std::size_t p_count, const Sample &p_sample, uint8_t *r_bytes, std::size_t p_room) {
	constexpr std::size_t MAX = 3 + 255;
	std::array<uint8_t, MAX> bytes;
	std::size_t at = 0;
	for (std::size_t i = 0; i < p_count; i++) {
		const std::size_t size = write_item(p_ids[i], p_sample, bytes.data());
		if (size == 0 || size > p_room - at) {
			return 0;
		}
		std::memcpy(r_bytes + at, bytes.data(), size);
		at += size;
	}
	return at;
}

} // namespace xbus
