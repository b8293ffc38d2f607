// SPDX-License-Identifier: MIT
// Hostile snapshots and acknowledgements: wire_fuzz_snapshots [EXECUTIONS [SEED]]. Built with
// sanitizers (DISMOUNT_SANITIZE) it finds what a wrong byte could do. What is refused must leave no
// trace: the next good snapshots are read, and say what the server has.
#include "replication_scene.hpp"

#include <cstdio>
#include <cstdlib>
#include <deque>

using namespace wire;

namespace {

using Bytes = std::vector<uint8_t>;
using Outcome = SnapshotDecoder::Outcome;

constexpr int GOOD = 1; // The client whose decoder is checked.
constexpr int HOSTILE = 2; // The client whose acknowledgements are nonsense.
constexpr int PEOPLE = 4;
constexpr int BODIES = 24;
// Good datagrams that are kept to be damaged or repeated.
constexpr std::size_t KEPT = 60;
// Ticks without attacks between two with them, so that there are baselines to be told against.
constexpr int QUIET_TICKS = 6;

class SnapshotFuzzer {
public:
	explicit SnapshotFuzzer(uint32_t p_seed) :
			random(p_seed), server(Scene::shape(), 0.1, 60), decoder(Scene::shape(), 0.1), poses(PEOPLE) {
		for (std::size_t i = 0; i < BODIES; i++) {
			bodies.emplace_back();
			bodies.back().id = uint16_t(3 * i);
		}
		server.add_client(GOOD, 60, 1e7);
		server.add_client(HOSTILE, 60, 1e6);
	}

	/// Some quiet ticks and one under attack; false if something that is good comes out wrong.
	bool run(long p_most) {
		for (int i = 0; i < QUIET_TICKS; i++) {
			if (!tick(false, 0)) {
				return false;
			}
		}
		return tick(true, std::min(p_most, 1 + long(random() % 256)));
	}

	long executions = 0;
	long accepted = 0;
	long good = 0;
	long refused_acks = 0;

private:
	bool tick(bool p_attack, long p_most) {
		move();
		std::vector<Bytes> fresh;
		const std::size_t count = server.encode(GOOD, 0, datagrams);
		fresh.reserve(count);
		for (std::size_t i = 0; i < count; i++) {
			fresh.emplace_back(
					datagrams[i].bytes.begin(), datagrams[i].bytes.begin() + std::ptrdiff_t(datagrams[i].size));
		}
		server.encode(HOSTILE, 0, datagrams);
		if (p_attack && !fresh.empty()) {
			const long before = accepted;
			if (!attack(fresh.front(), p_most)) {
				return false;
			}
			if (accepted > before) {
				return rejoin();
			}
		}
		waiting.insert(waiting.end(), fresh.begin(), fresh.end());
		// Some are late, and then overtaken.
		if (random() % 4 == 0 && waiting.size() < 4) {
			return true;
		}
		while (!waiting.empty()) {
			const Bytes next = waiting.back();
			waiting.pop_back();
			if (!take(next)) {
				return false;
			}
		}
		return true;
	}

	// Reads a good datagram and answers.
	bool take(const Bytes &p_bytes) {
		const Outcome outcome = decoder.decode(p_bytes.data(), p_bytes.size());
		// After joining anew, what was sent before the first whole tick cannot be read.
		if (outcome != Outcome::OK && outcome != Outcome::NOT_BEGUN) {
			std::printf("a good datagram: outcome %d\n", int(outcome));
			return false;
		}
		good += outcome == Outcome::OK ? 1 : 0;
		recent.push_back(p_bytes);
		if (recent.size() > KEPT) {
			recent.pop_front();
		}
		if (!is_right()) {
			std::printf("a good datagram: not the server's states\n");
			return false;
		}
		std::array<uint8_t, ClientRecord::ACK_BYTES> ack{};
		if (decoder.write_ack({}, ack)) {
			server.client(GOOD)->take_ack(ack.data(), ack.size(), server.world().tick());
		}
		return true;
	}

	// Whether the server had what was told.
	bool is_right() const {
		for (const PersonUpdate &update : decoder.people()) {
			const WorldHistory::Person &person = *server_history().people()[update.id];
			const PersonState *state = person.trail.find(update.tick);
			PersonPose pose;
			if (state == nullptr) {
				return false;
			}
			lattice.restore(*state, Scene::shape(), pose);
			for (std::size_t i = 0; i < 16; i++) {
				if (pose.orientations[i].dot(update.pose.orientations[i]) < 0.99999f) {
					return false;
				}
			}
		}
		for (const BodyUpdate &update : decoder.bodies()) {
			const BodyState *state = server_history().bodies()[update.id / 3]->trail.find(update.tick);
			BodyUpdate expected;
			if (state == nullptr) {
				return false;
			}
			restore_body(*state, expected);
			if ((expected.position - update.position).length() > 0.0f) {
				return false;
			}
		}
		return true;
	}

	bool attack(const Bytes &p_fresh, long p_most) {
		bool poisoned = false;
		// Half of the attacks go on behind a forgery that is accepted.
		const bool goes_on = random() % 2 == 0;
		for (long i = 0; i < p_most && (goes_on || !poisoned); i++) {
			executions++;
			if (random() % 8 == 0) {
				acknowledge();
				continue;
			}
			bool is_repeated = false;
			// Of just this size, so that a sanitizer sees what is read beyond.
			Bytes bytes = make(p_fresh, is_repeated);
			bytes.shrink_to_fit();
			const Outcome outcome = decoder.decode(bytes.data(), bytes.size());
			if (is_repeated && !poisoned && outcome == Outcome::OK) {
				std::printf("a repeated datagram counts twice\n");
				return false;
			}
			if (outcome == Outcome::OK) {
				poisoned = true;
				accepted++;
			} else if (!decoder.people().empty() || !decoder.bodies().empty() || decoder.mark() != nullptr) {
				std::printf("outcome %d, but something is told\n", int(outcome));
				return false;
			}
		}
		return true;
	}

	// Whoever could write what was accepted could write anything: the client joins anew.
	bool rejoin() {
		decoder.clear();
		server.add_client(GOOD, 60, 1e7);
		waiting.clear();
		recent.clear();
		return tick(false, 0);
	}

	Bytes make(const Bytes &p_fresh, bool &r_is_repeated) {
		Bytes bytes = p_fresh;
		switch (random() % 6) {
			case 0:
				bytes.resize(random() % 8 == 0 ? random() % 1400 : random() % 64);
				for (uint8_t &byte : bytes) {
					byte = uint8_t(random());
				}
				if (!bytes.empty() && random() % 4 != 0) {
					bytes[0] = uint8_t((bytes[0] & 0xf8U) | (random() % 2 == 0 ? 0U : 2U));
				}
				break;
			case 1:
				damage(bytes);
				break;
			case 2:
				bytes.resize(random() % bytes.size());
				break;
			case 3:
				if (!recent.empty()) {
					bytes = recent[random() % recent.size()];
					r_is_repeated = true;
				}
				break;
			case 4:
				if (!recent.empty()) {
					const Bytes &other = recent[random() % recent.size()];
					bytes.resize(random() % bytes.size());
					bytes.insert(bytes.end(), other.begin() + std::ptrdiff_t(random() % other.size()), other.end());
				}
				break;
			default:
				bytes.resize(bytes.size() + 1 + random() % 64);
				damage(bytes);
				break;
		}
		return bytes;
	}

	void damage(Bytes &r_bytes) {
		for (std::size_t i = 1 + random() % 4; i > 0 && !r_bytes.empty(); i--) {
			const std::size_t at = random() % 4 == 0 ? random() % std::min<std::size_t>(r_bytes.size(), 12)
													 : random() % r_bytes.size();
			r_bytes[at] = random() % 2 == 0 ? uint8_t(random()) : uint8_t(r_bytes[at] ^ (1U << (random() % 8)));
		}
	}

	void acknowledge() {
		Bytes bytes(random() % 4 == 0 ? random() % 64 : ClientRecord::ACK_BYTES);
		for (uint8_t &byte : bytes) {
			byte = uint8_t(random());
		}
		if (!bytes.empty() && random() % 8 != 0) {
			bytes[0] = uint8_t(Kind::ACK);
		}
		if (bytes.size() > 1 && random() % 4 != 0) {
			bytes[1] = 0;
		}
		const bool taken = server.client(HOSTILE)->take_ack(bytes.data(), bytes.size(), server.world().tick());
		refused_acks += taken ? 0 : 1;
	}

	const WorldHistory &server_history() const { return const_cast<SnapshotEncoder &>(server).world(); }

	void move() {
		now++;
		WorldHistory &world = server.world();
		world.begin(now);
		const float time = float(now) / 60.0f;
		for (std::size_t i = 0; i < poses.size(); i++) {
			poses[i].root = { float(i) + std::sin(time), 1.0f, std::cos(time) };
			for (std::size_t limb = 0; limb < 16; limb++) {
				poses[i].orientations[limb] =
						kinematics::exp({ std::sin(time * (1.0f + 0.1f * float(limb))), 0.0f, 0.2f * float(limb) });
			}
			world.put_person(uint16_t(i), poses[i]);
		}
		for (BodyUpdate &body : bodies) {
			if (random() % 20 == 0) {
				body.velocity = { float(random() % 9) - 4.0f, 0.0f, 1.0f };
				body.spin = { 0.0f, float(random() % 9) - 4.0f, 0.0f };
				body.at_rest = random() % 3 == 0;
			}
			body.position = body.position + body.velocity * (1.0f / 60.0f);
			body.orientation = (kinematics::exp(body.spin * (1.0f / 60.0f)) * body.orientation).normalized();
			world.put_body(body);
		}
		world.end();
	}

	std::mt19937 random;
	SnapshotEncoder server;
	SnapshotDecoder decoder;
	PersonLattice lattice{ PersonLattice::resolution_for(0.1) };
	std::vector<PersonPose> poses;
	std::vector<BodyUpdate> bodies;
	std::deque<Bytes> recent;
	std::vector<Bytes> waiting;
	std::array<Datagram, MAX_DATAGRAMS> datagrams{};
	uint32_t now = 1000;
};

} // namespace

int main(int p_count, char **p_arguments) {
	const long executions = p_count > 1 ? std::strtol(p_arguments[1], nullptr, 10) : 200000;
	SnapshotFuzzer fuzzer(p_count > 2 ? uint32_t(std::strtol(p_arguments[2], nullptr, 10)) : 1);
	while (fuzzer.executions < executions) {
		if (!fuzzer.run(executions - fuzzer.executions)) {
			std::printf("after %ld executions\n", fuzzer.executions);
			return 1;
		}
	}
	std::printf("%ld executions: %ld forgeries accepted, %ld acknowledgements refused; %ld good snapshots between\n",
			fuzzer.executions, fuzzer.accepted, fuzzer.refused_acks, fuzzer.good);
	return fuzzer.good > 0 ? 0 : 1;
}
