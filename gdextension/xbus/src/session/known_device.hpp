// SPDX-License-Identifier: MIT
#pragma once

#include "bus/bytes.hpp"
#include "bus/message.hpp"
#include "session/suit_frame.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace xbus {

/// What is known of the device at the other end and of the trackers behind it.
struct KnownDevice {
	DeviceKind kind = DeviceKind::UNKNOWN;
	uint32_t id = 0;
	std::array<uint32_t, MAX_TRACKERS> tracker_ids{};
	int tracker_count = 0;
	/// Whether a device of unknown kind is tried as a master now, or as a tracker that stands alone.
	bool is_unknown_master = false;

	bool is_master() const {
		return kind == DeviceKind::XBUS_MASTER || (kind == DeviceKind::UNKNOWN && is_unknown_master);
	}
	/// Whether its samples come as MTData2, with the items that were asked for, not as MTData.
	bool speaks_mtdata2() const {
		const bool is_unknown_tracker = kind == DeviceKind::UNKNOWN && !is_unknown_master;
		return kind == DeviceKind::MTI_10 || kind == DeviceKind::MTI_100 || is_unknown_tracker;
	}
	/// Whether what it says, and what makes its orientations, is public.
	bool has_public_protocol() const {
		return kind != DeviceKind::AWINDA_STATION && kind != DeviceKind::AWINDA_DONGLE &&
				kind != DeviceKind::BODY_PACK && kind != DeviceKind::MTW2_MTX2;
	}
	/// Takes the identifiers of a master's trackers, four bytes each. Returns false, and changes nothing, if that
	/// is no such list, or one of more than MAX_TRACKERS.
	bool take_trackers(const uint8_t *p_bytes, std::size_t p_size) {
		const std::size_t count = p_size / 4;
		if (p_size % 4 != 0 || count > std::size_t(MAX_TRACKERS)) {
			return false;
		}
		for (std::size_t tracker = 0; tracker < count; ++tracker) {
			tracker_ids[tracker] = read_u32(p_bytes + 4 * tracker);
		}
		tracker_count = int(count);
		return true;
	}
	uint8_t bus_id_of(int p_tracker) const { return is_master() ? uint8_t(p_tracker + 1) : MASTER; }
};

} // namespace xbus
