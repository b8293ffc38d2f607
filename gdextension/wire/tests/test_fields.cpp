// SPDX-License-Identifier: MIT
// Entities and their fields over a network that loses, delays and reorders.
#include "replication_scene.hpp"

#include <check.hpp>

namespace test_fields {

using namespace wire;

namespace {

constexpr uint8_t DOOR = 3; // An angle, a number, a step.
constexpr uint16_t FIRST = 2000;

void define(EntityTypes &r_types) {
	const uint8_t kinds[3] = { 0, 1, 2 };
	const float mins[3] = { 0.0f, -1.0f, 0.0f };
	const float maxs[3] = { 360.0f, 1.0f, 7.0f };
	const float resolutions[3] = { 0.1f, 0.001f, 1.0f };
	CHECK(r_types.define(DOOR, 3, kinds, mins, maxs, resolutions));
}

// A server with doors and a client, in simulated time.
class DoorWorld {
public:
	SnapshotEncoder server{ Scene::shape(), 0.1, 60 };
	SnapshotDecoder client{ Scene::shape(), 0.1 };
	uint32_t tick = 1000;
	int doors;
	int loss = 0;
	int delay = 0;
	int jitter = 0;
	std::map<int, int> outcomes;
	std::vector<std::size_t> sizes;
	DatagramList datagrams;

	explicit DoorWorld(int p_doors) : doors(p_doors) {
		define(server.world().entities().types());
		define(client.types());
		const float values[3] = { 10.0f, 0.5f, 2.0f };
		for (int i = 0; i < p_doors; i++) {
			CHECK(server.world().entities().add(uint16_t(FIRST + 3 * i), DOOR, values, 3, uint32_t(i + 1)));
			CHECK(client.add_entity(uint16_t(FIRST + 3 * i), DOOR, values, 3));
		}
		client.set_table_version(uint32_t(p_doors));
		server.add_client(1, 60, 1e7);
	}
	bool set(int p_door, std::size_t p_field, float p_value) {
		return server.world().entities().set(uint16_t(FIRST + 3 * p_door), p_field, p_value);
	}
	void step() {
		tick++;
		server.world().begin(tick);
		server.world().end();
		datagrams.clear();
		const std::size_t count = server.encode(1, 0, datagrams);
		for (std::size_t i = 0; i < count; i++) {
			sizes.push_back(datagrams[i].size);
			const std::vector<uint8_t> bytes(
					datagrams[i].bytes.begin(), datagrams[i].bytes.begin() + std::ptrdiff_t(datagrams[i].size));
			post({ true, bytes });
		}
		while (!_mail.empty() && _mail.begin()->first <= tick) {
			const Letter letter = _mail.begin()->second;
			_mail.erase(_mail.begin());
			letter.is_down ? receive(letter.bytes) : answer(letter.bytes);
		}
	}
	void run(int p_ticks) {
		for (int i = 0; i < p_ticks; i++) {
			step();
		}
	}
	bool is_same(int p_door) const {
		const uint16_t id = uint16_t(FIRST + 3 * p_door);
		const auto &values = const_cast<DoorWorld *>(this)->server.world().entities().find(id)->values;
		return std::equal(values.begin(), values.end(), client.newest_fields(id));
	}
	int wrong() const {
		int count = 0;
		for (int i = 0; i < doors; i++) {
			count += is_same(i) ? 0 : 1;
		}
		return count;
	}

private:
	struct Letter {
		bool is_down;
		std::vector<uint8_t> bytes;
	};
	void post(const Letter &p_letter) {
		if (int(_random() % 100) >= loss) {
			_mail.emplace(tick + uint32_t(delay) + uint32_t(_random() % uint32_t(jitter + 1)), p_letter);
		}
	}
	void receive(const std::vector<uint8_t> &p_bytes) {
		outcomes[int(client.decode(p_bytes.data(), p_bytes.size()))]++;
		for (const FieldUpdate &update : client.fields()) {
			// What comes is what the server had at that tick.
			const auto &history = *server.world().entities().find(update.id)->history;
			CHECK(std::equal(update.values, update.values + 3, history.in_force_at(update.tick)));
		}
		SnapshotDecoder::Ack ack{};
		const std::size_t size = client.write_ack({}, ack);
		if (size > 0) {
			post({ false, { ack.begin(), ack.begin() + std::ptrdiff_t(size) } });
		}
	}
	void answer(const std::vector<uint8_t> &p_bytes) {
		server.client(1)->take_ack(p_bytes.data(), p_bytes.size(), tick, server.world().entities().newest_version());
	}

	std::mt19937 _random{ 7 };
	std::multimap<uint32_t, Letter> _mail;
};

} // namespace

TEST(types_that_make_no_sense_are_refused) {
	EntityTypes types;
	const uint8_t kinds[2] = { 1, 9 };
	const float zero[2] = { 0.0f, 0.0f };
	const float ones[2] = { 1.0f, 1.0f };
	const float fine[2] = { 1e-8f, 1e-8f };
	const float nan[2] = { NAN, NAN };
	CHECK(types.define(0, 1, kinds, zero, ones, ones));
	CHECK(!types.define(1, 2, kinds, zero, ones, ones));
	CHECK(!types.define(2, 1, kinds, zero, zero, ones));
	CHECK(!types.define(3, 1, kinds, zero, ones, zero));
	CHECK(!types.define(4, 1, kinds, zero, ones, fine));
	CHECK(!types.define(5, 1, kinds, nan, ones, ones));
	CHECK(!types.define(6, 1, kinds, zero, nan, ones));
	CHECK(!types.define(0, 0, kinds, zero, ones, ones));
	CHECK(types.find(1) == nullptr && types.find(0) != nullptr);
}

TEST(values_are_cut_off_and_angles_turned_into_their_range) {
	DoorWorld world(1);
	EntityTable &entities = world.server.world().entities();
	float value = 0.0f;
	CHECK(world.set(0, 0, -30.0f) && entities.get(FIRST, 0, value));
	CHECK_NEAR(value, 330.0, 0.051);
	CHECK(world.set(0, 1, 5.0f) && entities.get(FIRST, 1, value));
	CHECK_NEAR(value, 1.0, 1e-6);
	CHECK(world.set(0, 2, NAN) && entities.get(FIRST, 2, value) && value == 0.0f);
	CHECK(!world.set(0, 3, 1.0f) && !entities.get(1, 0, value) && !entities.set(1, 0, 1.0f));
}

TEST(fields_arrive_over_a_bad_network) {
	for (const int loss : { 0, 5, 30 }) {
		DoorWorld world(60);
		world.loss = loss;
		world.delay = 3;
		world.jitter = 4;
		std::mt19937 random{ 3 };
		for (int round = 0; round < 20; round++) {
			for (int i = 0; i < 40; i++) {
				for (int change = 0; change < 8; change++) {
					world.set(int(random() % 60), random() % 3, float(random() % 1000) - 300.0f);
				}
				world.step();
			}
			// Also long pauses, from which on bases are old.
			world.run(round % 4 == 0 ? 300 : 10);
		}
		world.run(120);
		CHECK(world.wrong() == 0);
		CHECK(world.outcomes[int(SnapshotDecoder::Outcome::BROKEN)] == 0);
		CHECK(world.outcomes[int(SnapshotDecoder::Outcome::LACKS_BASELINE)] == 0);
	}
}

TEST(a_field_that_does_not_change_costs_nothing) {
	DoorWorld world(500);
	world.run(120);
	world.set(7, 0, 90.0f);
	world.run(120);
	world.sizes.clear();
	world.run(600);
	// Only what keeps the clocks in step: twice a second, a header of at most 10 bytes.
	CHECK(world.sizes.size() <= 21);
	for (const std::size_t size : world.sizes) {
		CHECK(size <= 10);
	}
	CHECK(world.server.client(1)->pending_fields.empty());
	CHECK(world.wrong() == 0);
}

TEST(nothing_unknown_is_ever_sent) {
	DoorWorld world(3);
	world.client.set_table_version(1);
	world.client.remove_entity(FIRST + 6);
	for (int i = 0; i < 3; i++) {
		world.set(i, 0, 200.0f);
	}
	world.run(60);
	CHECK(world.is_same(0) && !world.is_same(1));
	CHECK(world.outcomes[int(SnapshotDecoder::Outcome::BROKEN)] == 0);
	world.client.set_table_version(2);
	world.run(60);
	CHECK(world.is_same(1));
}

TEST(who_knows_the_table_takes_others_for_broken) {
	DoorWorld world(2);
	SnapshotDecoder other{ Scene::shape(), 0.1 };
	define(other.types());
	const float values[3] = { 10.0f, 0.5f, 2.0f };
	CHECK(other.add_entity(FIRST + 3, DOOR, values, 3));
	world.run(10);
	world.set(0, 0, 99.0f);
	world.run(1);
	CHECK(world.datagrams.size() > 0);
	world.server.add_client(2, 60, 1e7);
	world.server.client(2)->table_version = 2;
	DatagramList list;
	CHECK(world.server.encode(2, 0, list) == 1);
	CHECK(other.decode(list[0].bytes.data(), list[0].size) == SnapshotDecoder::Outcome::BROKEN);
}

TEST(a_removed_entity_is_read_but_not_told) {
	DoorWorld world(2);
	world.delay = 3;
	world.run(30);
	world.set(0, 0, 50.0f);
	world.run(2);
	world.client.remove_entity(FIRST);
	world.run(20);
	CHECK(world.outcomes[int(SnapshotDecoder::Outcome::BROKEN)] == 0);
	CHECK(!world.client.has_entity(FIRST) && world.client.has_entity(FIRST + 3));
}

TEST(a_client_that_lost_everything_learns_the_fields_again) {
	DoorWorld world(4);
	world.set(1, 1, -0.25f);
	world.run(60);
	world.client.clear();
	define(world.client.types());
	const float values[3] = { 10.0f, 0.5f, 2.0f };
	for (int i = 0; i < 4; i++) {
		CHECK(world.client.add_entity(uint16_t(FIRST + 3 * i), DOOR, values, 3));
	}
	world.client.set_table_version(4);
	for (int i = 0; i < 120; i++) {
		world.set(1, 1, float(i) * 0.01f - 0.9f);
		world.step();
	}
	world.run(30);
	CHECK(world.wrong() == 0);
}

TEST(commands_are_acknowledged_until_the_client_has_it) {
	DoorWorld world(1);
	CHECK(world.client.command_ack() == -1);
	world.loss = 40;
	world.run(10);
	for (const uint16_t number : { 1, 2, 65535, 3 }) {
		world.server.set_command_ack(1, number);
		world.run(60);
		CHECK(world.client.command_ack() == int(number));
		CHECK(world.server.client(1)->is_command_acked);
	}
}

TEST(a_recorder_gets_everything_of_every_tick) {
	DoorWorld world(300);
	SnapshotDecoder reader{ Scene::shape(), 0.1 };
	define(reader.types());
	const float values[3] = { 10.0f, 0.5f, 2.0f };
	for (int i = 0; i < 300; i++) {
		CHECK(reader.add_entity(uint16_t(FIRST + 3 * i), DOOR, values, 3));
	}
	world.server.add_recorder(9);
	DatagramList list;
	for (int round = 0; round < 90; round++) {
		for (int i = 0; i < 300; i++) {
			world.set(i, std::size_t(i % 3), float((round * 37 + i) % 300));
		}
		world.step();
		list.clear();
		const std::size_t count = world.server.encode(9, 0, list);
		for (std::size_t i = 0; i < count; i++) {
			CHECK(reader.decode(list[i].bytes.data(), list[i].size) == SnapshotDecoder::Outcome::OK);
		}
		for (int i = 0; i < 300; i++) {
			const auto &now = world.server.world().entities().find(uint16_t(FIRST + 3 * i))->committed;
			CHECK(std::equal(now.begin(), now.end(), reader.newest_fields(uint16_t(FIRST + 3 * i))));
		}
	}
}

TEST(forty_people_fit_in_few_datagrams) {
	Scene scene(40, 0, 0, 8e6);
	scene.run(120);
	CHECK(scene.clients[0].wrong == 0);
	CHECK(scene.known_people(0) == 40);
	const uint64_t before = scene.server.client(1)->stats.datagrams;
	scene.run(60);
	CHECK(scene.server.client(1)->stats.datagrams - before <= 60 * 2);
}

} // namespace test_fields
