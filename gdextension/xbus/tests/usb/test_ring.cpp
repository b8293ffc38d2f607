// SPDX-License-Identifier: MIT
#include "usb/ring.hpp"

#include "check.hpp"

#include <cstdint>
#include <thread>

namespace test_ring {

namespace {

/// More than a word, so that a torn entry would show.
struct Entry {
	uint64_t number = 0;
	uint64_t inverse = 0;
};

} // namespace

TEST(a_full_ring_takes_no_more_and_keeps_the_oldest) {
	usb::Ring<Entry, 4> ring;
	CHECK(ring.front() == nullptr);
	for (uint64_t number = 0; number < 3; ++number) {
		Entry *entry = ring.claim();
		CHECK(entry != nullptr);
		*entry = { number, ~number };
		ring.publish();
	}
	CHECK(ring.claim() == nullptr);
	CHECK(ring.front()->number == 0);
	ring.drop();
	CHECK(ring.claim() != nullptr);
	CHECK(ring.front()->number == 1);
}

TEST(what_one_thread_writes_another_reads_whole_and_in_order) {
	constexpr uint64_t COUNT = 20000;
	usb::Ring<Entry, 8> ring;
	std::thread writer([&ring] {
		for (uint64_t number = 0; number < COUNT;) {
			Entry *entry = ring.claim();
			if (entry == nullptr) {
				std::this_thread::yield();
				continue;
			}
			*entry = { number, ~number };
			ring.publish();
			++number;
		}
	});
	uint64_t expected = 0;
	bool is_sound = true;
	while (expected < COUNT) {
		const Entry *entry = ring.front();
		if (entry == nullptr) {
			std::this_thread::yield();
			continue;
		}
		is_sound = is_sound && entry->number == expected && entry->inverse == ~expected;
		ring.drop();
		++expected;
	}
	writer.join();
	CHECK(is_sound);
	CHECK(ring.front() == nullptr);
}

} // namespace test_ring
