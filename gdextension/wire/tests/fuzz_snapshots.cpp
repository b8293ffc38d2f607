// SPDX-License-Identifier: MIT
// Hostile snapshots and acknowledgements: wire_fuzz_snapshots [EXECUTIONS [SEED]]. Built with
// sanitizers (DISMOUNT_SANITIZE) it finds what a wrong byte could do. What is refused must leave no
// trace: the next good snapshots are read, and say what the server has.
#include "fuzzing.hpp"
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
constexpr uint16_t DOORS = 12; // Entities with fields.
constexpr uint16_t FIRST_DOOR = 2000;
constexpr std::array<float, 3> SPAWN{ 10.0f, 0.5f, 2.0f };
// Good datagrams that are kept to be damaged or repeated.
constexpr std::size_t KEPT = 60;
// Ticks without attacks between two with them, so that there are baselines to be coded against.
constexpr int QUIET_TICKS = 6;

class SnapshotFuzzer {
public:
	explicit SnapshotFuzzer(uint32_t p_seed) :
			_random(p_seed),
			_server(Scene::shape(), 0.1, 60),
			_decoder(Scene::shape(), 0.1),
			_poses(PEOPLE),
			_corpus(DISMOUNT_CORPUS, 1400) {
		for (std::size_t i = 0; i < BODIES; i++) {
			_bodies.emplace_back();
			_bodies.back().id = uint16_t(3 * i);
		}
		_define(_server.world().entities().types());
		for (uint16_t i = 0; i < DOORS; i++) {
			_server.world().entities().add(uint16_t(FIRST_DOOR + 5 * i), 1, SPAWN.data(), SPAWN.size(), 0);
		}
		_fill_table();
		_server.add_client(GOOD, 60, 1e7);
		_server.add_client(HOSTILE, 60, 1e6);
	}

	/// Some quiet ticks and one under attack; false if something that is good comes out wrong.
	bool run(long p_most) {
		for (int i = 0; i < QUIET_TICKS; i++) {
			if (!_tick(false, 0)) {
				return false;
			}
		}
		return _tick(true, std::min(p_most, 1 + long(_random() % 256)));
	}

	long executions = 0;
	long accepted = 0;
	long good = 0;
	long refused_acks = 0;

private:
	static void _define(EntityTypes &r_types) {
		const uint8_t kinds[3] = { 0, 1, 2 };
		const float mins[3] = { 0.0f, -1.0f, 0.0f };
		const float maxs[3] = { 360.0f, 1.0f, 5.0f };
		const float resolutions[3] = { 0.1f, 0.0001f, 1.0f };
		r_types.define(0, 0, kinds, mins, maxs, resolutions);
		r_types.define(1, 3, kinds, mins, maxs, resolutions);
	}
	// What the entity table has told the client.
	void _fill_table() {
		_define(_decoder.types());
		for (uint16_t id = 0; id < 3 * BODIES; id++) {
			_decoder.add_entity(id, 0, SPAWN.data(), 0);
		}
		for (uint16_t i = 0; i < DOORS; i++) {
			_decoder.add_entity(uint16_t(FIRST_DOOR + 5 * i), 1, SPAWN.data(), SPAWN.size());
		}
	}
	bool _tick(bool p_attack, long p_most) {
		_move();
		std::vector<Bytes> fresh;
		_datagrams.clear();
		const std::size_t count = _server.encode(GOOD, 0, _datagrams);
		fresh.reserve(count);
		for (std::size_t i = 0; i < count; i++) {
			fresh.emplace_back(
					_datagrams[i].bytes.begin(), _datagrams[i].bytes.begin() + std::ptrdiff_t(_datagrams[i].size));
		}
		_datagrams.clear();
		_server.encode(HOSTILE, 0, _datagrams);
		if (p_attack && !fresh.empty()) {
			const long before = accepted;
			if (!_attack(fresh.front(), p_most)) {
				return false;
			}
			if (accepted > before) {
				return _rejoin();
			}
		}
		_waiting.insert(_waiting.end(), fresh.begin(), fresh.end());
		// Some are late, and then overtaken.
		if (_random() % 4 == 0 && _waiting.size() < 4) {
			return true;
		}
		while (!_waiting.empty()) {
			const Bytes next = _waiting.back();
			_waiting.pop_back();
			if (!_take(next)) {
				return false;
			}
		}
		return true;
	}

	// Reads a good datagram and answers.
	bool _take(const Bytes &p_bytes) {
		const Outcome outcome = _decoder.decode(p_bytes.data(), p_bytes.size());
		// After joining anew, what was sent before the first whole tick cannot be read.
		if (outcome != Outcome::OK && outcome != Outcome::NOT_BEGUN) {
			std::printf("a good datagram: outcome %d\n", int(outcome));
			return false;
		}
		good += outcome == Outcome::OK ? 1 : 0;
		_recent.push_back(p_bytes);
		if (_recent.size() > KEPT) {
			_recent.pop_front();
		}
		if (!_is_right()) {
			std::printf("a good datagram: not the server's states\n");
			return false;
		}
		SnapshotDecoder::Ack ack{};
		const std::size_t size = _decoder.write_ack({}, ack);
		if (size > 0) {
			_server.client(GOOD)->take_ack(ack.data(), size, _server.world().tick());
		}
		return true;
	}

	// Whether the server had what was sent.
	bool _is_right() const {
		for (const PersonUpdate &update : _decoder.people()) {
			const WorldHistory::Person &person = *_server_history().people()[update.id];
			const PersonState *state = person.history.find(update.tick);
			PersonPose pose;
			if (state == nullptr) {
				return false;
			}
			_lattice.restore(*state, Scene::shape(), pose);
			for (std::size_t i = 0; i < 16; i++) {
				if (pose.orientations[i].dot(update.pose.orientations[i]) < 0.99999f) {
					return false;
				}
			}
		}
		for (const BodyUpdate &update : _decoder.bodies()) {
			const BodyState *state = _server_history().bodies()[update.id / 3]->history.find(update.tick);
			BodyUpdate expected;
			if (state == nullptr) {
				return false;
			}
			restore_body(*state, expected);
			if ((expected.position - update.position).length() > 0.0f) {
				return false;
			}
		}
		for (const FieldUpdate &update : _decoder.fields()) {
			const EntityTable::Entity *entity = _server_history().entities().find(update.id);
			const uint32_t *values = entity == nullptr ? nullptr : entity->history->in_force_at(update.tick);
			if (values == nullptr || !std::equal(values, values + SPAWN.size(), update.values)) {
				return false;
			}
		}
		return true;
	}

	bool _attack(const Bytes &p_fresh, long p_most) {
		bool poisoned = false;
		// Half of the attacks go on behind a forgery that is accepted.
		const bool goes_on = _random() % 2 == 0;
		for (long i = 0; i < p_most && (goes_on || !poisoned); i++) {
			executions++;
			if (_random() % 8 == 0) {
				_acknowledge();
				continue;
			}
			bool is_repeated = false;
			// Of just this size, so that a sanitizer sees what is read beyond.
			const Bytes *whole = _corpus.whole(_tried++);
			Bytes bytes = whole != nullptr ? *whole : _make(p_fresh, is_repeated);
			bytes.shrink_to_fit();
			fuzzing::LastInput::note(bytes.data(), bytes.size());
			const Outcome outcome = _decoder.decode(bytes.data(), bytes.size());
			if (is_repeated && !poisoned && outcome == Outcome::OK) {
				std::printf("a repeated datagram counts twice\n");
				return false;
			}
			if (outcome == Outcome::OK) {
				poisoned = true;
				accepted++;
			} else if (!_decoder.people().empty() || !_decoder.bodies().empty() || !_decoder.fields().empty() ||
					_decoder.mark() != nullptr) {
				std::printf("outcome %d, but something comes out\n", int(outcome));
				return false;
			}
		}
		return true;
	}

	// Whoever could write what was accepted could write anything: the client joins anew.
	bool _rejoin() {
		_decoder.clear();
		_fill_table();
		_server.add_client(GOOD, 60, 1e7);
		_waiting.clear();
		_recent.clear();
		return _tick(false, 0);
	}

	Bytes _make(const Bytes &p_fresh, bool &r_is_repeated) {
		Bytes bytes = p_fresh;
		switch (_random() % 7) {
			case 0:
				bytes.resize(_random() % 8 == 0 ? _random() % 1400 : _random() % 64);
				for (uint8_t &byte : bytes) {
					byte = uint8_t(_random());
				}
				if (!bytes.empty() && _random() % 4 != 0) {
					bytes[0] = std::array<uint8_t, 3>{ 0, 2, 10 }[_random() % 3];
					if (bytes.size() > 2 && bytes[0] != 10) {
						bytes[1] &= ALL_FLAGS;
						bytes[2] %= 8;
					}
				}
				break;
			case 1:
				_damage(bytes);
				break;
			case 5:
				bytes = _corpus.files()[_random() % _corpus.files().size()];
				_damage(bytes);
				break;
			case 2:
				bytes.resize(_random() % bytes.size());
				break;
			case 3:
				if (!_recent.empty()) {
					bytes = _recent[_random() % _recent.size()];
					r_is_repeated = true;
				}
				break;
			case 4:
				if (!_recent.empty()) {
					const Bytes &other = _recent[_random() % _recent.size()];
					bytes.resize(_random() % bytes.size());
					bytes.insert(bytes.end(), other.begin() + std::ptrdiff_t(_random() % other.size()), other.end());
				}
				break;
			default:
				bytes.resize(bytes.size() + 1 + _random() % 64);
				_damage(bytes);
				break;
		}
		return bytes;
	}

	void _damage(Bytes &r_bytes) {
		for (std::size_t i = 1 + _random() % 4; i > 0 && !r_bytes.empty(); i--) {
			const std::size_t at = _random() % 4 == 0 ? _random() % std::min<std::size_t>(r_bytes.size(), 12)
													  : _random() % r_bytes.size();
			r_bytes[at] = _random() % 2 == 0 ? uint8_t(_random()) : uint8_t(r_bytes[at] ^ (1U << (_random() % 8)));
		}
	}

	void _acknowledge() {
		const std::size_t right = ClientRecord::ACK_BYTES + (_random() % 2 == 0 ? ClientRecord::VIEWPOINT_BYTES : 0);
		Bytes bytes(_random() % 4 == 0 ? _random() % 64 : right);
		for (uint8_t &byte : bytes) {
			byte = uint8_t(_random());
		}
		if (!bytes.empty() && _random() % 8 != 0) {
			bytes[0] = uint8_t(Message::ACK);
		}
		if (bytes.size() > 1 && _random() % 4 != 0) {
			bytes[1] = right > ClientRecord::ACK_BYTES ? ClientRecord::HAS_VIEWPOINT : 0;
		}
		const bool taken = _server.client(HOSTILE)->take_ack(bytes.data(), bytes.size(), _server.world().tick());
		refused_acks += taken ? 0 : 1;
	}

	const WorldHistory &_server_history() const { return const_cast<SnapshotEncoder &>(_server).world(); }

	void _move() {
		_now++;
		WorldHistory &world = _server.world();
		world.begin(_now);
		const float time = float(_now) / 60.0f;
		for (BodyUpdate &body : _bodies) {
			if (_random() % 20 == 0) {
				body.velocity = { float(_random() % 9) - 4.0f, 0.0f, 1.0f };
				body.spin = { 0.0f, float(_random() % 9) - 4.0f, 0.0f };
				body.at_rest = _random() % 3 == 0;
			}
			body.position = body.position + body.velocity * (1.0f / 60.0f);
			body.orientation = (kinematics::exp(body.spin * (1.0f / 60.0f)) * body.orientation).normalized();
			world.put_body(body);
		}
		// After the bodies, one of which carries somebody now and then.
		for (std::size_t i = 0; i < _poses.size(); i++) {
			_poses[i].root = { float(i) + std::sin(time), 1.0f, std::cos(time) };
			for (std::size_t limb = 0; limb < 16; limb++) {
				_poses[i].orientations[limb] =
						kinematics::exp({ std::sin(time * (1.0f + 0.1f * float(limb))), 0.0f, 0.2f * float(limb) });
			}
			world.set_frame(uint16_t(i), i == 1 && (_now / 100) % 2 == 0 ? uint16_t(3) : uint16_t(0));
			world.put_person(uint16_t(i), _poses[i]);
		}
		for (int i = 0; i < 3; i++) {
			const uint16_t door = uint16_t(FIRST_DOOR + 5 * (_random() % DOORS));
			world.entities().set(door, _random() % 3, float(_random() % 4000) * 0.1f - 20.0f);
		}
		world.end();
	}

	std::mt19937 _random;
	SnapshotEncoder _server;
	SnapshotDecoder _decoder;
	PersonLattice _lattice{ PersonLattice::resolution_for(0.1) };
	std::vector<PersonPose> _poses;
	fuzzing::Corpus _corpus;
	uint64_t _tried = 0;
	std::vector<BodyUpdate> _bodies;
	std::deque<Bytes> _recent;
	std::vector<Bytes> _waiting;
	DatagramList _datagrams;
	uint32_t _now = 1000;
};

} // namespace

int main(int p_count, char **p_arguments) {
	const long executions = p_count > 1 ? std::strtol(p_arguments[1], nullptr, 10) : 200000;
	SnapshotFuzzer fuzzer(p_count > 2 ? uint32_t(std::strtol(p_arguments[2], nullptr, 10)) : 1);
	fuzzing::LastInput::arm();
	while (fuzzer.executions < executions) {
		if (!fuzzer.run(executions - fuzzer.executions)) {
			fuzzing::LastInput::keep();
			std::printf("after %ld executions\n", fuzzer.executions);
			return 1;
		}
	}
	std::printf("%ld executions: %ld forgeries accepted, %ld acknowledgements refused; %ld good snapshots between\n",
			fuzzer.executions, fuzzer.accepted, fuzzer.refused_acks, fuzzer.good);
	return fuzzer.good > 0 ? 0 : 1;
}
