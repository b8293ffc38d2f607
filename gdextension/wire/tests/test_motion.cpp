// SPDX-License-Identifier: MIT
#include "people.hpp"

#include <check.hpp>
#include <motion/motion_decoder.hpp>
#include <motion/motion_encoder.hpp>
#include <replication/datagram.hpp>
#include <replication/snapshot_decoder.hpp>

#include <deque>
#include <vector>

namespace test_motion {

using namespace wire;

namespace {

constexpr double ERROR_DEG = 0.1;
constexpr int64_t BEGIN_USEC = 1700000000000000;
constexpr int64_t HELD_USEC = 130;

using Bytes = std::vector<uint8_t>;

/// A client with some people, a server, and what lies between.
struct Stream {
	explicit Stream(std::size_t p_people, uint32_t p_first = 7) :
			encoder(people::skeleton(), ERROR_DEG, p_first), decoder(people::skeleton(), ERROR_DEG), poses(p_people) {
		for (PersonPose &pose : poses) {
			pose = people::draw_pose(random);
		}
	}

	/// Everybody moves a little; the datagram of it.
	Bytes next() {
		step++;
		encoder.begin(time_usec(), HELD_USEC + int64_t(random() % 40), sent_usec());
		for (std::size_t i = 0; i < poses.size(); i++) {
			poses[i] = people::moved(random, poses[i], 0.02f);
			CHECK(encoder.put(i, uint32_t(100 * i) + step, time_usec() - int64_t(300 * i), poses[i]));
		}
		Bytes bytes(MAX_BYTES);
		bytes.resize(encoder.finish(bytes.data(), bytes.size()));
		CHECK(!bytes.empty());
		return bytes;
	}
	int64_t time_usec() const { return BEGIN_USEC + int64_t(step) * 16667 + int64_t(step % 5) + jump_usec; }
	int64_t sent_usec() const { return 5000000 + int64_t(step) * 16667; }
	MotionDecoder::Outcome receive(const Bytes &p_bytes) { return decoder.decode(p_bytes.data(), p_bytes.size()); }
	/// Whether the server has what the client sent last, as far as it is to.
	bool agrees() const {
		const MotionPacket &packet = decoder.packet();
		const int64_t held_usec = packet.held * MotionPacket::UNIT_USEC;
		bool good = std::abs(packet.time_usec - time_usec()) <= 10 && std::abs(held_usec - HELD_USEC) <= 50 &&
				std::abs(packet.sent_usec() - sent_usec()) <= 60;
		for (std::size_t i = 0; i < poses.size(); i++) {
			PersonPose found;
			decoder.restore(i, found);
			good = good && packet.has(i) &&
					std::abs(packet.time_usec + packet.persons[i].late_usec - time_usec() + int64_t(300 * i)) <= 10 &&
					packet.persons[i].id == uint32_t(100 * i) + step &&
					people::error_of(found, poses[i], 16) < ERROR_DEG * 1.001 &&
					(found.root - poses[i].root).length() < 0.0004f;
		}
		return good;
	}
	void acknowledge() {
		uint8_t ack[MotionDecoder::ACK_BYTES];
		CHECK(decoder.write_ack(ack));
		CHECK(encoder.take_ack(ack, sizeof(ack)));
	}

	std::mt19937 random{ 5 };
	MotionEncoder encoder;
	MotionDecoder decoder;
	std::vector<PersonPose> poses;
	uint32_t step = 0;
	int64_t jump_usec = 0;
};

} // namespace

TEST(everybody_arrives_and_baselines_make_it_small) {
	for (const std::size_t count : { std::size_t(1), std::size_t(3), MAX_WEARERS }) {
		Stream stream(count, 0xFFFFFFF0); // The numbers come round.
		std::size_t whole = 0;
		std::size_t after = 0;
		for (int i = 0; i < 200; i++) {
			const Bytes bytes = stream.next();
			whole = i == 0 ? bytes.size() : whole;
			after = bytes.size();
			CHECK(stream.receive(bytes) == MotionDecoder::Outcome::OK);
			CHECK(stream.decoder.used() == bytes.size());
			CHECK(stream.agrees());
			stream.acknowledge();
		}
		CHECK(after * 3 < whole * 2);
	}
}

TEST(loss_and_reordering_cost_only_what_is_lost) {
	Stream stream(2);
	std::deque<Bytes> way;
	std::deque<std::array<uint8_t, MotionDecoder::ACK_BYTES>> back;
	int read = 0;
	int sent = 0;
	for (int i = 0; i < 3000; i++) {
		way.push_back(stream.next());
		sent += i >= 10 ? 1 : 0;
		if (stream.random() % 5 == 0) {
			way.pop_back(); // Lost.
			sent -= i >= 10 ? 1 : 0;
		} else if (way.size() > 1 && stream.random() % 8 == 0) {
			std::swap(way[way.size() - 1], way[way.size() - 2]);
		}
		if (way.size() > 4) {
			const MotionDecoder::Outcome outcome = stream.receive(way.front());
			CHECK(outcome == MotionDecoder::Outcome::OK);
			read += outcome == MotionDecoder::Outcome::OK ? 1 : 0;
			way.pop_front();
			back.emplace_back();
			CHECK(stream.decoder.write_ack(back.back().data()));
		}
		if (back.size() > 4) {
			if (stream.random() % 5 != 0) {
				stream.encoder.take_ack(back.front().data(), MotionDecoder::ACK_BYTES);
			}
			back.pop_front();
		}
	}
	CHECK(read >= sent - 6);
}

TEST(a_datagram_that_comes_twice_is_old) {
	Stream stream(1);
	const Bytes first = stream.next();
	CHECK(stream.receive(first) == MotionDecoder::Outcome::OK);
	CHECK(stream.receive(first) == MotionDecoder::Outcome::OLD);
	stream.acknowledge();
	const Bytes second = stream.next();
	CHECK(stream.receive(second) == MotionDecoder::Outcome::OK);
	CHECK(stream.receive(second) == MotionDecoder::Outcome::OLD);
	MotionDecoder other(people::skeleton(), ERROR_DEG);
	CHECK(other.decode(second.data(), second.size()) == MotionDecoder::Outcome::UNKNOWN_BASE);
}

TEST(an_encoder_that_begins_anew_is_understood) {
	Stream stream(1);
	for (int i = 0; i < 20; i++) {
		CHECK(stream.receive(stream.next()) == MotionDecoder::Outcome::OK);
		stream.acknowledge();
	}
	stream.encoder = MotionEncoder(people::skeleton(), ERROR_DEG, 0x80000000);
	for (int i = 0; i < 60; i++) {
		CHECK(stream.receive(stream.next()) == MotionDecoder::Outcome::OK);
		CHECK(stream.agrees());
		stream.acknowledge();
	}
}

TEST(silence_of_acknowledgements_leads_to_whole_poses) {
	Stream stream(1);
	const std::size_t whole = stream.next().size();
	CHECK(stream.receive(stream.next()) == MotionDecoder::Outcome::OK);
	stream.acknowledge();
	const std::size_t small = stream.next().size();
	CHECK(small < whole);
	for (int i = 0; i < 40; i++) {
		stream.next();
	}
	const Bytes bytes = stream.next();
	CHECK(bytes.size() + 8 > whole);
	CHECK(stream.receive(bytes) == MotionDecoder::Outcome::OK);
	CHECK(stream.agrees());
}

TEST(people_may_come_and_go) {
	Stream stream(1);
	for (int i = 0; i < 100; i++) {
		if (i % 10 == 9) {
			stream.poses.resize(1 + std::size_t(i / 10) % MAX_WEARERS, people::draw_pose(stream.random));
		}
		CHECK(stream.receive(stream.next()) == MotionDecoder::Outcome::OK);
		CHECK(stream.agrees());
		stream.acknowledge();
	}
}

TEST(what_follows_is_left_to_others) {
	Stream stream(1);
	Bytes bytes = stream.next();
	const std::size_t size = bytes.size();
	bytes.insert(bytes.end(), { 5, 0, 1, 2, 3, 4, 5, 6, 7 });
	CHECK(stream.receive(bytes) == MotionDecoder::Outcome::OK);
	CHECK(stream.decoder.used() == size);
}

TEST(what_is_no_pose_is_refused) {
	Stream stream(1);
	stream.encoder.begin(1, 2, 3);
	PersonPose bad = stream.poses[0];
	bad.orientations[5] = { 0.0f, 0.0f, 0.0f, 0.0f };
	CHECK(!stream.encoder.put(0, 1, 1, bad));
	CHECK(!stream.encoder.put(MAX_WEARERS, 1, 1, stream.poses[0]));
	uint8_t bytes[MAX_BYTES];
	CHECK(stream.encoder.finish(bytes, sizeof(bytes)) == 0);
	for (const int64_t odd : { int64_t(-1), INT64_MIN, INT64_MAX, int64_t(0) }) {
		stream.encoder.begin(odd, odd, odd);
		CHECK(stream.encoder.put(0, 1, odd, stream.poses[0]));
		const std::size_t size = stream.encoder.finish(bytes, sizeof(bytes));
		CHECK(size > 0);
		CHECK(stream.decoder.decode(bytes, size) == MotionDecoder::Outcome::OK);
	}
	const uint8_t ack[3] = { 1, 2, 3 };
	CHECK(!stream.encoder.take_ack(ack, sizeof(ack)));
}

TEST(times_are_kept_however_they_jump) {
	Stream stream(2);
	std::size_t steady = 0;
	for (int i = 0; i < 400; i++) {
		if (i % 20 == 10) {
			// A thread that woke up late, a machine that slept, a clock that was set back or forth.
			constexpr int64_t JUMPS[5] = { 300, 60000, -4000000, int64_t(1) << 45, -(int64_t(1) << 45) };
			stream.jump_usec += JUMPS[i / 20 % 5];
		}
		const Bytes bytes = stream.next();
		steady = i == 9 ? bytes.size() : steady;
		CHECK(stream.receive(bytes) == MotionDecoder::Outcome::OK);
		CHECK(stream.agrees());
		CHECK(i < 10 || bytes.size() < steady + 30);
		stream.acknowledge();
	}
}

// The example in docs/protocol.md: whoever writes a client of their own begins with these bytes.
TEST(the_example_of_the_protocol) {
	MotionEncoder encoder(people::skeleton(), ERROR_DEG, 0x01020304);
	MotionDecoder decoder(people::skeleton(), ERROR_DEG);
	const std::array<Bytes, 2> expected{ {
			{ 0x01, 0x01, 0x02, 0x02, 0x02, 0xFA, 0x1B, 0xA4, 0xBE, 0xF8, 0xDD, 0xF8, 0x72, 0x3F, 0xF7, 0x3F, 0x70,
					0x2C, 0x78, 0x3C, 0x68, 0x78, 0x89, 0x3E, 0xEF, 0x4C, 0x43, 0x3A, 0x93, 0x58, 0x7B, 0x1A, 0x87,
					0x01, 0xB3, 0x10, 0x19, 0x5F, 0x06, 0x95, 0xBE, 0x90, 0xF2, 0xF3, 0xB7, 0x50, 0x38, 0x84, 0x1E,
					0x52, 0xB1, 0x73, 0x35, 0x6A, 0xD5, 0x6B, 0x2E, 0x99, 0x65, 0x7E, 0xC3, 0x0D, 0x58, 0x79, 0x01,
					0x3F, 0x83, 0xDE, 0x47, 0xB3, 0x99, 0xB3 },
			{ 0x85, 0x29, 0xB3, 0x43, 0x66, 0xDF, 0x8C, 0x37, 0xF8, 0x71, 0x25, 0x6D, 0x11, 0x90, 0xB4, 0x53, 0xEF,
					0x61, 0x02, 0xC0, 0x8F },
	} };
	for (int64_t i = 0; i < 2; i++) {
		PersonPose pose; // The reset pose, its hips a metre above the ground.
		for (Quat &rotation : pose.orientations) {
			rotation = Quat();
		}
		pose.root = { 0.25f, 1.0f, 0.0f };
		// Then the head nods by 10 degrees, and everything moves 2 cm forwards.
		pose.orientations[3] = kinematics::exp({ float(i) * 10.0f * 3.14159265f / 180.0f, 0.0f, 0.0f });
		pose.root.z = float(i) * 0.02f;
		encoder.begin(1700000000000000 + 16700 * i, 120 + 100 * i, 0);
		CHECK(encoder.put(0, uint32_t(100 + i), 1700000000000000 + 16700 * i, pose));
		Bytes bytes(MAX_BYTES);
		bytes.resize(encoder.finish(bytes.data(), bytes.size()));
		CHECK(bytes == expected[std::size_t(i)]);
		CHECK(decoder.decode(bytes.data(), bytes.size()) == MotionDecoder::Outcome::OK);
		uint8_t ack[MotionDecoder::ACK_BYTES];
		CHECK(decoder.write_ack(ack) && ack[0] == 4 + i && ack[1] == i);
		CHECK(encoder.take_ack(ack, sizeof(ack)));
		CHECK(decoder.packet().time_usec == 1700000000000000 + (i == 0 ? 0 : 16697));
		CHECK(decoder.packet().held == (i == 0 ? 12 : 22));
	}
}

TEST(an_acknowledgement_is_found_without_decoding) {
	const uint8_t key[] = { 0, 4, 0, 9, 1, 2, 3, 4, 60, 8, 0xAB, 0xCD };
	const uint8_t *found = SnapshotDecoder::find_motion_ack(key, sizeof(key));
	CHECK(found == key + 10);
	CHECK(SnapshotDecoder::find_motion_ack(key, sizeof(key) - 1) == nullptr);
	const uint8_t with_command[] = { 2, 6, 0, 9, 1, 8, 0x12, 0x34, 0xAB, 0xCD, 77 };
	CHECK(SnapshotDecoder::find_motion_ack(with_command, sizeof(with_command)) == with_command + 8);
	const uint8_t none[] = { 2, 2, 0, 9, 1, 8, 0x12, 0x34, 0xAB, 0xCD, 77 };
	CHECK(SnapshotDecoder::find_motion_ack(none, sizeof(none)) == nullptr);
	const uint8_t alone[] = { 10, 4, 0, 9, 1, 8, 0x12, 0x34, 0xAB, 0xCD, 77 };
	CHECK(SnapshotDecoder::find_motion_ack(alone, sizeof(alone)) == nullptr);
	CHECK(SnapshotDecoder::find_motion_ack(nullptr, 0) == nullptr);
}

TEST(damaged_and_random_bytes_do_no_harm) {
	Stream stream(2);
	long read = 0;
	for (int i = 0; i < 60000; i++) {
		Bytes bytes = stream.next();
		Bytes bad = bytes;
		if (i % 4 == 0) {
			bad.resize(stream.random() % 100);
			for (uint8_t &byte : bad) {
				byte = uint8_t(stream.random());
			}
			if (!bad.empty() && i % 8 == 0) {
				bad[0] = i % 16 == 0 ? 1 : uint8_t(bytes[0]);
			}
		} else {
			for (std::size_t n = 1 + stream.random() % 3; n > 0; n--) {
				bad[1 + stream.random() % (bad.size() - 1)] ^= uint8_t(1U << (stream.random() % 8));
			}
			bad.resize(bad.size() - (i % 4 == 1 ? stream.random() % bad.size() : 0));
		}
		MotionDecoder copy = stream.decoder;
		if (copy.decode(bad.data(), bad.size()) == MotionDecoder::Outcome::OK) {
			read++;
			const MotionPacket &packet = copy.packet();
			CHECK(packet.people != 0 && packet.time_usec >= 0 && packet.sent_usec() >= 0);
			for (std::size_t person = 0; person < MAX_WEARERS; person++) {
				PersonPose pose;
				if (packet.has(person)) {
					copy.restore(person, pose);
					CHECK(pose.root.is_finite() && pose.orientations[15].is_finite());
				}
			}
		}
		if (i % 3 == 0) {
			CHECK(stream.receive(bytes) == MotionDecoder::Outcome::OK);
			stream.acknowledge();
		}
	}
	CHECK(read > 100);
}

} // namespace test_motion
