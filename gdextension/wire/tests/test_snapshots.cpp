// SPDX-License-Identifier: MIT
#include "replication_scene.hpp"

#include <check.hpp>

namespace test_snapshots {

using namespace wire;

TEST(a_client_has_the_servers_states_to_the_last_digit) {
	Scene scene(4, 30, 0);
	scene.run(600);
	CHECK(scene.clients[0].wrong == 0);
	CHECK(scene.clients[0].right_people > 4 * 500);
	CHECK(scene.clients[0].right_bodies > 100);
	CHECK(scene.clients[0].outcomes[int(SnapshotDecoder::Outcome::BROKEN)] == 0);
}

TEST(a_datagram_has_room_for_many_people) {
	Scene scene(MAX_PEOPLE, 0, 0);
	scene.run(300);
	CHECK(scene.clients[0].wrong == 0);
	CHECK(scene.clients[0].most_people > 25);
	scene.stop(); // Who stands still takes a byte or two.
	scene.run(60);
	CHECK(scene.clients[0].most_people == std::size_t(MAX_PEOPLE));
}

TEST(loss_delay_and_overtaking_do_no_harm) {
	for (const int loss : { 2, 20, 50 }) {
		Scene scene(3, 20, loss);
		scene.clients[0].delay = 3;
		scene.clients[0].jitter = 4;
		scene.run(1500);
		CHECK(scene.clients[0].wrong == 0);
		CHECK(scene.clients[0].outcomes[int(SnapshotDecoder::Outcome::BROKEN)] == 0);
		CHECK(scene.clients[0].right_people > 3 * 1500 * (100 - loss) / 100 * 8 / 10);
		// Everything has been sent, and not long ago.
		CHECK(scene.oldest_person(0) < 60);
		scene.stop();
		scene.run(120);
		CHECK(scene.worst_body_error(0) < 0.002f);
	}
}

TEST(a_late_joiner_learns_everything) {
	Scene scene(6, 200, 2);
	scene.run(300);
	scene.join();
	scene.run(120);
	CHECK(scene.known_people(1) == 6);
	CHECK(scene.known_bodies(1) == 200);
	CHECK(scene.clients[1].wrong == 0);
}

TEST(a_client_that_lost_everything_recovers_by_itself) {
	Scene scene(2, 10, 0);
	scene.run(200);
	scene.clients[0].decoder->clear();
	const int before = scene.clients[0].right_people;
	scene.run(120);
	CHECK(scene.clients[0].wrong == 0);
	CHECK(scene.clients[0].right_people - before > 2 * 50);
}

TEST(a_forged_tick_far_ahead_does_not_last) {
	for (const uint8_t ahead : { uint8_t(0x7f), uint8_t(0x01), uint8_t(0x40) }) {
		Scene scene(2, 10, 0);
		scene.run(200);
		const std::array<uint8_t, 10> forged{ 0, 0, 0, 200, 0, 0, 0, ahead, 60, 0 };
		CHECK(scene.clients[0].decoder->decode(forged.data(), forged.size()) == SnapshotDecoder::Outcome::OK);
		scene.run(120);
		const int before = scene.clients[0].right_people;
		scene.run(60);
		CHECK(scene.clients[0].wrong == 0);
		CHECK(scene.clients[0].right_people - before > 2 * 50);
	}
}

TEST(old_datagrams_again_do_not_make_a_client_forget) {
	Scene scene(2, 10, 0);
	scene.run(200);
	const std::array<uint8_t, 10> old{ 0, 0, 0, 200, 0, 0, 0, 0, 60, 0 };
	for (int i = 0; i < 200; i++) {
		for (int again = 0; again < 20; again++) {
			scene.clients[0].decoder->decode(old.data(), old.size());
		}
		scene.run(10);
	}
	CHECK(scene.clients[0].wrong == 0);
	CHECK(scene.clients[0].right_people > 2 * 2100);
}

TEST(a_client_that_never_answers_still_gets_updates) {
	Scene scene(2, 10, 0);
	scene.clients[0].answers = false;
	scene.run(300);
	CHECK(scene.clients[0].wrong == 0);
	CHECK(scene.clients[0].right_people > 2 * 200);
}

TEST(who_leaves_and_whose_place_is_taken) {
	Scene scene(4, 10, 10);
	scene.clients[0].delay = 5;
	for (int round = 0; round < 20; round++) {
		scene.run(17);
		scene.rename_person(round % 4, uint16_t(100 + round));
	}
	scene.run(60);
	CHECK(scene.clients[0].wrong == 0);
	CHECK(scene.known_people(0) == 4);
}

TEST(a_client_keeps_to_its_share) {
	Scene scene(8, 200, 0, 64000.0);
	scene.run(1200);
	const double seconds = 20.0;
	const double rate = double(scene.server.client(1)->stats.bytes) * 8.0 / seconds;
	CHECK(rate < 64000.0 * 1.05);
	CHECK(rate > 64000.0 * 0.5);
	CHECK(scene.clients[0].wrong == 0);
	CHECK(scene.known_people(0) == 8);
}

TEST(a_lower_rate_gives_fewer_snapshots) {
	Scene scene(1, 0, 0, 256000.0, 20);
	scene.run(600);
	CHECK_NEAR(double(scene.clients[0].right_people), 200.0, 3.0);
}

TEST(a_jolt_does_not_wait_for_the_next_snapshot) {
	Scene scene(1, 1, 0, 256000.0, 10);
	scene.still = true;
	scene.run(100);
	while (scene.tick % 6 != 3) {
		scene.run(1);
	}
	scene.bodies[0].velocity = { 8.0f, 0.0f, 0.0f };
	scene.bodies[0].at_rest = false;
	const int before = scene.clients[0].right_bodies;
	scene.run(1);
	CHECK(scene.clients[0].right_bodies == before + 1);
}

TEST(what_rests_costs_nothing) {
	Scene scene(0, 200, 0);
	scene.still = true;
	scene.run(200);
	const uint64_t before = scene.server.client(1)->stats.bytes;
	scene.run(600);
	CHECK(scene.server.client(1)->stats.bytes - before < 10 * 2 * 60);
	CHECK(scene.known_bodies(0) == 200);
}

TEST(what_is_out_of_sight_is_sent_rarely) {
	Scene scene(2, 0, 0);
	// Two cells: people stand in the first, and the client sees only the second.
	const uint8_t table[4] = { 1, 0, 0, 1 };
	CHECK(scene.server.interest().set_cells({ -500.0f, -50.0f, -500.0f }, 1000.0f, { 2, 1, 1 }, table, 4));
	scene.clients[0].viewpoint = { 600.0f, 0.0f, 0.0f };
	scene.run(60);
	const int before = scene.clients[0].right_people;
	scene.run(600);
	const int received = scene.clients[0].right_people - before;
	CHECK(received > 2 * 20 && received < 2 * 100);
}

TEST(an_outage_of_any_length_is_mended_at_once) {
	for (const int ticks : { 20, 60, 100, 128, 150, 200, 255, 256, 300, 380, 1000 }) {
		Scene scene(2, 20, 0);
		scene.run(120);
		scene.is_cut = true;
		scene.run(ticks);
		scene.is_cut = false;
		const int before = scene.clients[0].right_people;
		scene.run(30);
		CHECK(scene.clients[0].wrong == 0);
		CHECK(scene.clients[0].right_people - before >= 2 * 25);
		CHECK(scene.clients[0].newest_tick == scene.tick);
	}
}

TEST(people_do_not_starve_when_there_is_little_room) {
	for (const double bits : { 8000.0, 16000.0, 32000.0 }) {
		Scene scene(8, 200, 0, bits);
		scene.kicks_often = true;
		scene.run(1800);
		CHECK(scene.clients[0].wrong == 0);
		CHECK(scene.known_people(0) == 8);
		CHECK(scene.oldest_person(0) < 600);
		CHECK(double(scene.server.client(1)->stats.bytes) * 8.0 / 30.0 < bits * 1.1 + 1000.0);
	}
}

TEST(any_rate_of_snapshots_is_kept) {
	for (const int rate : { 7, 20, 40, 45, 59, 60 }) {
		Scene scene(1, 0, 0, 256000.0, rate);
		scene.run(600);
		CHECK_NEAR(double(scene.clients[0].right_people), 10.0 * rate, 2.0);
	}
}

TEST(a_slow_server_that_leaves_out_ticks_still_sends_jolts) {
	Scene scene(1, 1, 0, 256000.0, 10);
	scene.still = true;
	scene.run(100);
	scene.ticks_at_once = 3;
	scene.run(8);
	scene.bodies[0].velocity = { 8.0f, 0.0f, 0.0f };
	scene.bodies[0].at_rest = false;
	const int before = scene.clients[0].right_bodies;
	scene.run(1);
	CHECK(scene.clients[0].right_bodies == before + 1);
}

TEST(who_has_left_is_forgotten) {
	Scene scene(3, 0, 0);
	scene.run(30);
	scene.clients[0].decoder->keep_people({ 0, 2 });
	const int before = scene.clients[0].right_people;
	scene.run(1);
	// The server does not know that: the client asks for all, and has it soon.
	CHECK(scene.clients[0].outcomes[int(SnapshotDecoder::Outcome::LACKS_BASELINE)] == 1);
	scene.run(10);
	CHECK(scene.clients[0].right_people - before >= 3 * 8);
	CHECK(scene.clients[0].wrong == 0);
}

} // namespace test_snapshots
