// SPDX-License-Identifier: MIT
#pragma once

#include <replication/snapshot_decoder.hpp>
#include <replication/snapshot_encoder.hpp>

#include <map>
#include <queue>
#include <random>

namespace wire {

/// A server with people and bodies that move, clients, and a network between them that delays and loses:
/// all in simulated time, a tick at a time.
class Scene {
public:
	struct Client {
		std::unique_ptr<SnapshotDecoder> decoder;
		int delay = 0; ///< Ticks, in each direction.
		int jitter = 0; ///< Up to so many more.
		bool answers = true;
		Vec3 viewpoint;
		std::size_t most_people = 0; ///< In one datagram.
		int right_people = 0;
		int right_bodies = 0;
		int wrong = 0; ///< Updates that are not what the server had.
		std::map<int, int> outcomes;
		uint32_t newest_tick = 0;
		std::map<uint16_t, uint32_t> people; ///< Tick of the newest update.
		std::map<uint16_t, BodyUpdate> bodies;
	};

	SnapshotEncoder server;
	std::vector<Client> clients;
	std::vector<PersonPose> poses;
	std::vector<uint16_t> ids;
	std::vector<BodyUpdate> bodies;
	uint32_t tick = 1000;
	bool still = false;
	bool is_cut = false; ///< Nothing gets through.
	bool kicks_often = false; ///< Bodies hardly ever rest.
	uint32_t ticks_at_once = 1; ///< A slow server makes several steps and sends the last.

	Scene(int p_people, int p_bodies, int p_loss, double p_bits = 1e6, int p_rate = 60) :
			server(shape(), 0.1, 60), _loss(p_loss), _bits(p_bits), _rate(p_rate) {
		for (int i = 0; i < p_people; i++) {
			poses.emplace_back();
			poses.back().root = { float(i), 1.0f, 0.0f };
			ids.push_back(uint16_t(i));
		}
		for (int i = 0; i < p_bodies; i++) {
			BodyUpdate body;
			body.id = uint16_t(3 * i);
			const int row = i / 20;
			body.position = { float(i % 20), 0.25f, float(row) };
			body.at_rest = true;
			bodies.push_back(body);
		}
		join();
	}

	static Skeleton shape() {
		Skeleton skeleton;
		skeleton.limb_count = 16;
		const std::array<int, 16> parents{ -1, 0, 1, 2, 2, 4, 5, 2, 7, 8, 0, 10, 11, 0, 13, 14 };
		std::copy(parents.begin(), parents.end(), skeleton.parents.begin());
		return skeleton;
	}

	void join() {
		Client client;
		client.decoder = std::make_unique<SnapshotDecoder>(shape(), 0.1);
		clients.push_back(std::move(client));
		server.add_client(int(clients.size()), _rate, _bits);
	}

	void rename_person(int p_person, uint16_t p_id) { ids[std::size_t(p_person)] = p_id; }

	void run(int p_ticks) {
		for (int i = 0; i < p_ticks; i++) {
			tick += ticks_at_once;
			_move();
			_simulate();
			for (std::size_t c = 0; c < clients.size(); c++) {
				_send(c);
			}
			_deliver();
		}
	}

	/// Everything comes to rest where it is.
	void stop() {
		still = true;
		for (BodyUpdate &body : bodies) {
			body.velocity = body.spin = {};
			body.at_rest = true;
		}
	}

	uint32_t oldest_person(int p_client) const {
		uint32_t oldest = 0;
		for (const auto &[id, newest] : clients[std::size_t(p_client)].people) {
			oldest = std::max(oldest, tick - newest);
		}
		return oldest;
	}

	float worst_body_error(int p_client) const {
		float worst = 0.0f;
		for (const BodyUpdate &body : bodies) {
			const auto &known = clients[std::size_t(p_client)].bodies;
			const BodyUpdate &update = known.at(body.id);
			const BodyTransform position = predict(update, float(tick - update.tick) / 60.0f);
			worst = std::max(worst, (position.position - body.position).length());
		}
		return worst;
	}

	std::size_t known_people(int p_client) const {
		std::size_t count = 0;
		for (const uint16_t id : ids) {
			const auto &people = clients[std::size_t(p_client)].people;
			count += people.count(id) > 0 ? 1 : 0;
		}
		return count;
	}
	std::size_t known_bodies(int p_client) const { return clients[std::size_t(p_client)].bodies.size(); }

private:
	struct Packet {
		std::size_t client;
		bool is_ack;
		std::vector<uint8_t> bytes;
	};

	float _noise(float p_size) { return std::normal_distribution<float>(0.0f, p_size)(_random); }
	Vec3 _noise_vector(float p_size) { return { _noise(p_size), _noise(p_size), _noise(p_size) }; }

	void _move() {
		if (still) {
			for (BodyUpdate &body : bodies) {
				body.position = body.position + body.velocity * (1.0f / 60.0f);
			}
			return;
		}
		const float time = float(tick) / 60.0f;
		for (std::size_t i = 0; i < poses.size(); i++) {
			poses[i].root = { float(i) + std::sin(time), 1.0f + 0.05f * std::sin(9.0f * time), std::cos(time) };
			for (std::size_t limb = 0; limb < 16; limb++) {
				const float swing = std::sin((1.0f + 0.1f * float(limb)) * time + float(i));
				poses[i].orientations[limb] = kinematics::exp({ swing, 0.3f * swing, 0.2f * float(limb) });
			}
		}
		for (BodyUpdate &body : bodies) {
			const bool kicked = _random() % (kicks_often ? 10 : 300) == 0;
			const bool stops = _random() % (kicks_often ? 1000 : 300) == 1;
			if (kicked) {
				body.velocity = _noise_vector(1.0f);
				body.spin = _noise_vector(2.0f);
				body.at_rest = false;
			} else if (stops) {
				body.velocity = body.spin = {};
				body.at_rest = true;
			}
			body.position = body.position + body.velocity * (1.0f / 60.0f);
			body.orientation = (kinematics::exp(body.spin * (1.0f / 60.0f)) * body.orientation).normalized();
		}
	}

	void _simulate() {
		WorldHistory &world = server.world();
		world.begin(tick);
		for (std::size_t i = 0; i < poses.size(); i++) {
			world.put_person(ids[i], poses[i]);
		}
		for (const BodyUpdate &body : bodies) {
			world.put_body(body);
		}
		world.end();
	}

	void _post(std::size_t p_client, bool p_is_ack, const uint8_t *p_bytes, std::size_t p_size) {
		if (is_cut || int(_random() % 100) < _loss) {
			return;
		}
		const Client &client = clients[p_client];
		const uint32_t late = uint32_t(client.delay) + uint32_t(_random() % uint32_t(client.jitter + 1));
		_post_box.emplace(tick + late, Packet{ p_client, p_is_ack, { p_bytes, p_bytes + p_size } });
	}

	void _send(std::size_t p_client) {
		_datagrams.clear();
		const std::size_t count = server.encode(int(p_client) + 1, 0, _datagrams);
		for (std::size_t i = 0; i < count; i++) {
			_post(p_client, false, _datagrams[i].bytes.data(), _datagrams[i].size);
		}
	}

	void _deliver() {
		while (!_post_box.empty() && _post_box.begin()->first <= tick) {
			const Packet packet = _post_box.begin()->second;
			_post_box.erase(_post_box.begin());
			if (packet.is_ack) {
				server.client(int(packet.client) + 1)
						->take_ack(packet.bytes.data(), packet.bytes.size(), tick,
								server.world().entities().newest_version());
			} else {
				_receive(packet);
			}
		}
	}

	void _receive(const Packet &p_packet) {
		Client &client = clients[p_packet.client];
		const auto outcome = client.decoder->decode(p_packet.bytes.data(), p_packet.bytes.size());
		client.outcomes[int(outcome)]++;
		client.newest_tick = outcome == SnapshotDecoder::Outcome::OK ? client.decoder->tick() : client.newest_tick;
		client.most_people = std::max(client.most_people, client.decoder->people().size());
		for (const PersonUpdate &update : client.decoder->people()) {
			_check_person(client, update);
		}
		for (const BodyUpdate &update : client.decoder->bodies()) {
			_check_body(client, update);
		}
		SnapshotDecoder::Ack ack{};
		const std::size_t size = client.answers ? client.decoder->write_ack(client.viewpoint, ack) : 0;
		if (size > 0) {
			_post(p_packet.client, true, ack.data(), size);
		}
	}

	static bool _is_equal(const Quat &p_a, const Quat &p_b) {
		return p_a.x == p_b.x && p_a.y == p_b.y && p_a.z == p_b.z && p_a.w == p_b.w;
	}

	void _check_person(Client &r_client, const PersonUpdate &p_update) {
		for (const auto &person : server.world().people()) {
			const PersonState *state = person->id == p_update.id ? person->history.find(p_update.tick) : nullptr;
			if (state == nullptr) {
				continue;
			}
			PersonPose pose;
			_lattice.restore(*state, shape(), pose);
			bool same = (pose.root - p_update.pose.root).length() == 0.0f;
			for (std::size_t i = 0; i < 16; i++) {
				same = same && _is_equal(pose.orientations[i], p_update.pose.orientations[i]);
			}
			same ? r_client.right_people++ : r_client.wrong++;
			uint32_t &newest = r_client.people[p_update.id];
			newest = std::max(newest, p_update.tick);
		}
	}

	void _check_body(Client &r_client, const BodyUpdate &p_update) {
		for (const auto &body : server.world().bodies()) {
			const BodyState *state = body->id == p_update.id ? body->history.find(p_update.tick) : nullptr;
			if (state == nullptr) {
				continue;
			}
			BodyUpdate expected;
			restore_body(*state, expected);
			const bool same = (expected.position - p_update.position).length() == 0.0f &&
					(expected.velocity - p_update.velocity).length() == 0.0f &&
					_is_equal(expected.orientation, p_update.orientation) && expected.at_rest == p_update.at_rest;
			same ? r_client.right_bodies++ : r_client.wrong++;
			BodyUpdate &newest = r_client.bodies[p_update.id];
			newest = p_update.tick >= newest.tick ? p_update : newest;
		}
	}

	int _loss;
	double _bits;
	int _rate;
	PersonLattice _lattice{ PersonLattice::resolution_for(0.1) };
	std::mt19937 _random{ 5 };
	std::multimap<uint32_t, Packet> _post_box;
	DatagramList _datagrams;
};

} // namespace wire
