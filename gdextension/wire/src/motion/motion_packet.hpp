// SPDX-License-Identifier: MIT
#pragma once

#include "coding/person_codec.hpp"
#include "motion/motion_beat.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace wire {

/// People of one client, at most.
constexpr std::size_t MAX_WEARERS = 8;

/// One person at the moment of a datagram.
struct MotionPerson {
	uint32_t id = 0; ///< Number of the sample at its source.
	int64_t late_usec = 0; ///< When it was taken, after the datagram's time.
	PersonState state; ///< The root is where the hips are, in units of MotionCoding::ROOT_UNIT.
};

/// What a datagram of motion says: some people of a client at one moment.
struct MotionPacket {
	uint32_t number = 0; ///< Grows by one with each datagram.
	bool is_known = false; ///< Sent and acknowledged, or received.
	int64_t time_usec = 0; ///< When the first sample was taken, Unix time of the wearer's machine.
	int64_t held = 0; ///< How long that was held before it was sent, 10 us.
	bool has_sent = false; ///< Whether the client knows the server's clock.
	int64_t ahead = 0; ///< Server's clock minus Unix time of the wearer's machine, 10 us.
	uint8_t people = 0; ///< Bit i: the client's person i is in it.
	MotionBeat beat; ///< Of the datagrams up to this one.
	MotionSteps held_steps; ///< How much held changed, HELD_STEP.
	MotionSteps ahead_steps; ///< How much ahead changed.
	std::array<MotionPerson, MAX_WEARERS> persons{};

	bool has(std::size_t p_person) const { return ((people >> p_person) & 1U) != 0; }
	/// When it was sent, us of the server's clock; 0 where that is not known.
	int64_t sent_usec() const { return has_sent ? time_usec + (held + ahead) * UNIT_USEC : 0; }

	static constexpr int64_t UNIT_USEC = 10;
	static constexpr int64_t HELD_STEP = 5; ///< In units.
};

/// The datagrams of the last second, by number.
class MotionHistory {
public:
	static constexpr uint32_t KEPT = 64;

	MotionPacket &slot(uint32_t p_number) { return _packets[p_number % KEPT]; }
	/// The datagram of a number, or null if it is not kept or of no use as a baseline.
	const MotionPacket *find(uint32_t p_number) const {
		const MotionPacket &packet = _packets[p_number % KEPT];
		return packet.is_known && packet.number == p_number ? &packet : nullptr;
	}
	void clear() {
		for (MotionPacket &packet : _packets) {
			packet.is_known = false;
		}
	}

private:
	std::array<MotionPacket, KEPT> _packets{};
};

} // namespace wire
