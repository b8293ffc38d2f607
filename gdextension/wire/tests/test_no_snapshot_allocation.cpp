// SPDX-License-Identifier: MIT
#include "count_allocations.hpp"
#include "replication_scene.hpp"

#include <check.hpp>

using namespace wire;

namespace {

constexpr std::size_t CLIENTS = 3;
constexpr std::size_t PEOPLE = 8;
constexpr std::size_t BODIES = 200;
constexpr uint16_t DOORS = 100;
constexpr uint16_t FIRST_DOOR = 2000;

/// A crowd among crates; its clients see each tick at once, but for those of one that are lost.
struct Crowd {
	SnapshotEncoder server{ Scene::shape(), 0.1, 60 };
	std::array<std::unique_ptr<SnapshotDecoder>, CLIENTS> clients;
	std::array<PersonPose, PEOPLE> poses;
	std::vector<BodyUpdate> bodies{ BODIES };
	DatagramList datagrams;
	std::mt19937 random{ 1 };
	uint32_t tick = 1000;
	int received = 0;

	Crowd() {
		const uint8_t kinds[2] = { 0, 1 };
		const float mins[2] = { 0.0f, 0.0f };
		const float maxs[2] = { 360.0f, 1.0f };
		const float resolutions[2] = { 0.1f, 0.001f };
		CHECK(server.world().entities().types().define(1, 2, kinds, mins, maxs, resolutions));
		CHECK(server.world().entities().types().define(0, 0, kinds, mins, maxs, resolutions));
		for (std::unique_ptr<SnapshotDecoder> &client : clients) {
			client = std::make_unique<SnapshotDecoder>(Scene::shape(), 0.1);
			CHECK(client->types().define(1, 2, kinds, mins, maxs, resolutions));
			CHECK(client->types().define(0, 0, kinds, mins, maxs, resolutions));
			for (uint16_t id = 0; id < BODIES; id++) {
				CHECK(client->add_entity(id, 0, mins, 0));
			}
			CHECK(client->add_entity(5000, 0, mins, 0));
		}
		for (uint16_t i = 0; i < DOORS; i++) {
			CHECK(server.world().entities().add(uint16_t(FIRST_DOOR + i), 1, mins, 2, 0));
			for (std::unique_ptr<SnapshotDecoder> &client : clients) {
				CHECK(client->add_entity(uint16_t(FIRST_DOOR + i), 1, mins, 2));
			}
		}
		for (std::size_t c = 0; c < CLIENTS; c++) {
			// One has plenty, one has little, and one asks for half as many.
			server.add_client(int(c), c == 2 ? 30 : 60, c == 1 ? 128000.0 : 4e6);
		}
		for (std::size_t i = 0; i < BODIES; i++) {
			bodies[i].id = uint16_t(i);
			bodies[i].position = { float(i % 20), 0.25f, 0.05f * float(i) };
		}
	}

	void move(bool p_all_bodies) {
		tick++;
		WorldHistory &world = server.world();
		world.begin(tick);
		const float time = float(tick) / 60.0f;
		for (std::size_t i = 0; i < PEOPLE; i++) {
			poses[i].root = { float(i) + std::sin(time), 1.0f, std::cos(time) };
			for (std::size_t limb = 0; limb < 16; limb++) {
				poses[i].orientations[limb] = kinematics::exp({ std::sin(time + float(limb)), 0.1f * float(i), 0.0f });
			}
			world.put_person(uint16_t(i), poses[i]);
		}
		for (BodyUpdate &body : bodies) {
			if (p_all_bodies || random() % 100 == 0) {
				body.velocity = { float(random() % 7) - 3.0f, 0.0f, float(random() % 7) - 3.0f };
				body.at_rest = random() % 2 == 0;
			}
			body.position = body.position + body.velocity * (body.at_rest ? 0.0f : 1.0f / 60.0f);
			world.put_body(body);
		}
		for (uint16_t i = 0; i < DOORS; i += uint16_t(1 + random() % 7)) {
			world.entities().set(uint16_t(FIRST_DOOR + i), random() % 2, float(random() % 1000) * 0.001f);
		}
		world.end();
		for (std::size_t i = 0; i < PEOPLE; i++) {
			Mark mark;
			mark.person = uint16_t(i);
			server.set_mark(mark);
		}
	}

	void send() {
		for (std::size_t c = 0; c < CLIENTS; c++) {
			SnapshotDecoder &client = *clients[c];
			datagrams.clear();
			const std::size_t count = server.encode(int(c), 0, datagrams);
			for (std::size_t i = 0; i < count; i++) {
				if (c == 0 && random() % 5 == 0) {
					continue;
				}
				client.decode(datagrams[i].bytes.data(), datagrams[i].size);
				received += int(client.people().size() + client.bodies().size() + client.fields().size());
			}
			SnapshotDecoder::Ack ack{};
			const std::size_t size = client.write_ack({ 1.0f, 2.0f, 3.0f }, ack);
			if (size > 0) {
				server.client(int(c))->take_ack(ack.data(), size, tick);
			}
		}
	}

	void run(int p_ticks) {
		for (int i = 0; i < p_ticks; i++) {
			move(i % 100 == 50);
			send();
		}
	}
};

} // namespace

TEST(sending_a_world_takes_no_memory) {
	Crowd crowd;
	crowd.run(60);
	crowd.received = 0;
	const int before = allocations;
	crowd.run(1200);
	CHECK(allocations == before);
	CHECK(crowd.received > 1200 * int(PEOPLE));
	// The counter counts.
	::operator delete(::operator new(4));
	CHECK(allocations > before);
}

TEST(only_what_is_new_takes_memory) {
	Crowd crowd;
	crowd.run(60);
	const int before = allocations;
	crowd.bodies.emplace_back();
	crowd.bodies.back().id = 5000;
	const int own = allocations - before;
	crowd.run(60);
	// A position on the server, in its index and in the clients' records, and a history for each client; some
	// tables grow.
	CHECK(allocations - before - own > 0);
	CHECK(allocations - before - own < 8 * int(CLIENTS));
}

TEST_MAIN()
