// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>

namespace wire {

/// Largest datagram, bytes: it passes every usual network in one piece.
constexpr std::size_t MAX_BYTES = 1200;
/// Bytes that UDP, IP (28) and ENet (12) add to each datagram.
constexpr std::size_t TRANSPORT_BYTES = 40;
/// Datagrams of a client in one tick, at most.
constexpr std::size_t MAX_DATAGRAMS = 4;
/// People in a datagram, at most.
constexpr int MAX_PEOPLE = 40;
/// Bodies in a datagram, at most.
constexpr int MAX_BODIES = 256;
/// Entities in a datagram whose fields are sent, at most.
constexpr int MAX_FIELD_ENTITIES = 256;
/// Datagrams of a recorder in one tick, at most.
constexpr std::size_t MAX_RECORDED = 256;
/// Ids from here on are not people's; those of bodies and fields are counted from here, and wrap.
constexpr uint16_t FIRST_THING = 1024;
/// States are of use as a baseline for so many ticks.
constexpr int MAX_AGE = 127;
/// Ticks that are kept of everything.
constexpr int HISTORY = 128;
/// A datagram that is so many ticks older than the newest is dropped: its number may have come round.
constexpr int32_t STALE = 30;
/// A whole tick that is so many ticks newer than all before begins the numbers anew.
constexpr int32_t GAP = 10;

/// First byte of a message.
enum class Message : uint8_t {
	KEY = 0, ///< A snapshot with the whole tick and the tick rate.
	SNAPSHOT = 2, ///< With the tick's low byte.
	ACK = 5, ///< From a client.
	SNAPSHOT_OF_ONE = 10, ///< A SNAPSHOT of one person and nothing else: without flags and number of people.
};
/// Flags of a snapshot: what is in it besides people. The other bits are 0.
constexpr uint8_t HAS_MARK = 1;
constexpr uint8_t HAS_COMMAND_ACK = 2;
constexpr uint8_t HAS_MOTION_ACK = 4;
constexpr uint8_t HAS_BODIES = 8;
constexpr uint8_t HAS_FIELDS = 16;
constexpr uint8_t ALL_FLAGS = 31;
/// Bytes of an acknowledgement of motion.
constexpr std::size_t MOTION_ACK_BYTES = 2;

/// Which states a datagram's entries are coded against, unless they say otherwise.
struct Baseline {
	int age = 0; ///< Ticks; 0: nothing.
	int spacing = 0; ///< Ticks from the one before to it; 0: there is none.

	static constexpr int MAX_SHORT_AGE = 31;
	static constexpr int MAX_SPACING = 7;

	bool operator==(const Baseline &p_other) const { return age == p_other.age && spacing == p_other.spacing; }
	/// As one byte, where the age fits.
	uint8_t pack() const { return uint8_t(age <= MAX_SHORT_AGE ? (age << 3) | spacing : 0); }
	static Baseline unpack(uint8_t p_byte) {
		const int age = p_byte >> 3;
		return { age, age == 0 ? 0 : p_byte & 7 };
	}
};

/// When a sample that moved a person was where, for measuring delays (thesis section 7.4).
struct Mark {
	uint16_t person = 0;
	uint32_t sample = 0; ///< Number of the sample.
	int64_t simulated_usec = 0; ///< End of the tick that used it, in the server's clock.
	/// Steps before that, in units of 10 us, at most 655 ms: sampled to sent, sent to received (both
	/// clocks compared by the client), received to simulated; and from then to the sending.
	std::array<uint16_t, 4> steps{};

	static constexpr std::size_t BYTES = 2 + 4 + 8 + 4 * 2;
	static constexpr int64_t STEP_USEC = 10;
};

/// Writes a number's low bytes, little-endian.
inline void put_number(uint8_t *p_at, uint64_t p_number, int p_bytes) {
	for (int i = 0; i < p_bytes; i++) {
		p_at[i] = uint8_t(p_number >> (8 * i));
	}
}

inline uint64_t get_number(const uint8_t *p_at, int p_bytes) {
	uint64_t number = 0;
	for (int i = 0; i < p_bytes; i++) {
		number |= uint64_t(p_at[i]) << (8 * i);
	}
	return number;
}

/// A datagram in a buffer of its own.
struct Datagram {
	std::array<uint8_t, MAX_BYTES> bytes{};
	std::size_t size = 0;
};

/// Datagrams to be sent. What it has had room for once it has room for again.
class DatagramList {
public:
	void clear() { _count = 0; }
	std::size_t size() const { return _count; }
	const Datagram &operator[](std::size_t p_index) const { return _datagrams[p_index]; }
	/// One more, at the end.
	Datagram &add() {
		if (_count == _datagrams.size()) {
			_datagrams.emplace_back();
		}
		return _datagrams[_count++];
	}
	void remove_last() { _count--; }

private:
	std::deque<Datagram> _datagrams;
	std::size_t _count = 0;
};

} // namespace wire
