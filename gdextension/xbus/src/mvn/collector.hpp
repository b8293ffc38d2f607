// SPDX-License-Identifier: MIT
#pragma once

#include "mvn/datagram.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace mvn {

/// Characters in one stream at most.
constexpr int MAX_CHARACTERS = 32;
constexpr int TYPES = 26;

/// How a character's samples come.
struct CharacterStatistics {
	/// Whole samples, of all types.
	uint64_t samples = 0;
	/// Samples of the pose that the counter counted and that never came. A sender may leave samples out: what is
	/// left out regularly does not count.
	uint64_t lost = 0;
	/// Samples of which a part never came, and those of them of which the body could be used all the same.
	uint64_t incomplete = 0;
	uint64_t partial = 0;
	/// Datagrams that came twice, or after newer ones.
	uint64_t late = 0;
	/// Those of them that hold something else than what came under their numbers before: of another person.
	uint64_t conflicting = 0;
	/// Datagrams of this character from somebody else than its sender.
	uint64_t foreign = 0;
	/// How often the counter of the pose began anew.
	uint64_t jumps = 0;
	/// Time of the newest, µs, and samples of the pose per second.
	uint64_t newest_usec = 0;
	double rate_hz = 0.0;
};

/// What became of a datagram.
enum class Outcome : uint8_t {
	REFUSED, ///< See `Collector::fault`.
	PART, ///< More must come.
	LATE, ///< Of no use any more, or twice.
	FOREIGN, ///< Another sender has a character of this number.
	CROWDED, ///< There are as many characters as can be.
	SAMPLE, ///< A sample is whole: see `Collector::content`.
};

/// Puts the datagrams of a stream together, by character, type and sample. No I/O, no clock.
class Collector {
public:
	/// Takes a datagram that came from a sender (any number that distinguishes senders) at a time, µs.
	Outcome take(const uint8_t *p_bytes, std::size_t p_size, uint64_t p_sender, uint64_t p_now_usec);

	/// Samples whose last parts never came, as far as they are whole: a body without its fingers. They are older
	/// than what `take` has just returned. Takes them.
	std::vector<Content> take_partial();

	/// What the last whole sample holds; valid until the next `take`.
	const Content &content() const { return *_content; }
	/// The head of the last datagram that had one.
	const Header &header() const { return _header; }
	Fault fault() const { return _fault; }
	/// Datagrams refused, by their fault.
	uint64_t refused(Fault p_fault) const { return _refused[std::size_t(p_fault)]; }
	uint64_t datagrams() const { return _datagrams; }
	/// Characters seen, with how they come.
	std::vector<std::pair<int, CharacterStatistics>> characters() const;
	/// Of one character; all zeros for one that is not there.
	CharacterStatistics statistics(int p_character) const;
	/// Forgets characters of whom nothing came since a time, µs.
	void forget_silent(uint64_t p_since_usec);

private:
	struct Part {
		Header header;
		std::vector<uint8_t> payload;
	};
	/// A sample that is being put together.
	struct Pending {
		bool is_begun = false;
		uint32_t sample = 0;
		std::size_t bytes = 0;
		std::vector<Part> parts;
		std::size_t part_count = 0;
	};
	/// What a datagram was about, to tell one that comes twice from one of another person.
	struct Print {
		uint32_t sample = 0;
		uint8_t part = 0;
		uint64_t hash = 0;
		bool is_known = false;
	};
	/// The samples of one type. The network may let a datagram overtake those of the sample before.
	struct Slot {
		std::array<Pending, 2> pending;
		bool has_whole = false;
		uint32_t newest_whole = 0;
		uint64_t whole_usec = 0;
		Content content;
		std::array<Print, 64> prints;
	};
	struct Character {
		uint64_t sender = 0;
		std::array<Slot, TYPES> slots;
		CharacterStatistics statistics;
		uint64_t metered_usec = 0;
		uint32_t metered = 0;
		/// The type of pose that is counted, and when it came last.
		Type leader = Type::POSE;
		uint64_t leader_usec = 0;
		uint32_t last_sample = 0;
		uint32_t step = 0;
		bool has_last = false;
	};

	Outcome refuse(Fault p_fault);
	Outcome add(Character &p_character, const uint8_t *p_payload, std::size_t p_size, uint64_t p_now_usec);
	Pending &pending_of(Character &p_character, Slot &p_slot);
	Outcome count_late(Character &p_character, Slot &p_slot, uint64_t p_hash);
	void give_up(Character &p_character, Slot &p_slot, Pending &p_pending);
	static Print &print_of(Slot &p_slot, const Header &p_header);
	Outcome store_part(Pending &p_pending, const uint8_t *p_payload, std::size_t p_size);
	static bool is_complete(const Pending &p_pending);
	static void sort_parts(Pending &p_pending);
	static Fault read_parts(const Pending &p_pending, std::size_t p_count, Content &r_content);
	void note_sample(Character &p_character, const Header &p_header, uint64_t p_now_usec);
	static void clear(Content &p_content);

	std::map<int, Character> _characters;
	Header _header;
	const Content *_content = nullptr;
	std::vector<Content> _partial;
	Fault _fault = Fault::NONE;
	std::array<uint64_t, FAULTS> _refused{};
	uint64_t _datagrams = 0;
};

} // namespace mvn
