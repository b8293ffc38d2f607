// SPDX-License-Identifier: MIT
// An attacker for the tests of whole processes:
//
//   transport_flood half-open <port> <handshakes a second> <honest> <address> [password]
//       Begins handshakes from many ports of an address of loopback and ends none. Beside it, from
//       127.0.0.1, so many honest handshakes run to their end, one after the other.
//   transport_flood guess <port> <honest> <address> <password>
//       Guesses the password from many ports of an address, as fast as it is answered, and begins anew
//       from the same port as soon as a guess is out. Beside it so many honest handshakes.
//   transport_flood forged <port> <datagrams> <address>
//       Sends that many datagrams of all types that nobody who has the key has made.
//
// Prints what it has done as JSON.
#include "clock.hpp"
#include "relay/client_relay.hpp"
#include "relay/relay_socket.hpp"

#include <arpa/inet.h>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <netinet/in.h>
#include <random>
#include <string>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

using namespace transport;

namespace {

/// Protocol.VERSION.
constexpr uint32_t VERSION = 9;
constexpr size_t PORTS = 800;
constexpr size_t GUESSERS = 40;
/// Pauses between two honest handshakes, us.
constexpr int64_t HONEST_USEC = 50000;
/// After so long the honest ones count as kept out.
constexpr int64_t PATIENCE_USEC = 120000000;

/// A UDP socket that is connected to the server.
class Port {
public:
	Port(const std::string &p_address, uint16_t p_server) {
		sockaddr_in at = loopback(p_address, 0);
		sockaddr_in to = loopback("127.0.0.1", p_server);
		if (bind(_socket, reinterpret_cast<sockaddr *>(&at), sizeof(at)) != 0 ||
				connect(_socket, reinterpret_cast<sockaddr *>(&to), sizeof(to)) != 0) {
			std::perror("transport_flood");
			std::exit(1);
		}
	}
	~Port() { close(_socket); }
	Port(const Port &) = delete;
	Port &operator=(const Port &) = delete;

	/// Lets an epoll name it by a number where there is something to read.
	void watch(int p_epoll, uint32_t p_number) const {
		epoll_event event{};
		event.events = EPOLLIN;
		event.data.u32 = p_number;
		epoll_ctl(p_epoll, EPOLL_CTL_ADD, _socket, &event);
	}
	void write(const View &p_bytes) const { ::send(_socket, p_bytes.data, p_bytes.size, MSG_DONTWAIT); }
	/// False if nothing has come.
	bool read(Bytes &r_bytes) const {
		r_bytes.resize(2048);
		const ssize_t count = recv(_socket, r_bytes.data(), r_bytes.size(), MSG_DONTWAIT);
		r_bytes.resize(count > 0 ? size_t(count) : 0);
		return count >= 0;
	}

private:
	static sockaddr_in loopback(const std::string &p_address, uint16_t p_port) {
		sockaddr_in made{};
		made.sin_family = AF_INET;
		made.sin_port = htons(p_port);
		inet_pton(AF_INET, p_address.c_str(), &made.sin_addr);
		return made;
	}

	int _socket = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
};

/// Handshakes like a real client's, until the server has shown that it has the key.
class Honest {
public:
	Honest(uint16_t p_server, const std::string &p_password) :
			_server(p_server), _password(p_password.begin(), p_password.end()) {}

	void go_on(int64_t p_now_usec) {
		if (!_relay && p_now_usec >= _next_usec) {
			_port = std::make_unique<Port>("127.0.0.1", _server);
			ClientRelay::Settings settings;
			settings.version = VERSION;
			settings.password = _password;
			_relay = std::make_unique<ClientRelay>(
					settings, [this](const View &p_bytes) { _port->write(p_bytes); }, [](const View &) {},
					[](const View &) {});
		}
		if (!_relay) {
			return;
		}
		while (_port->read(_bytes)) {
			_relay->take_outer(_bytes, p_now_usec);
		}
		_relay->look_after(p_now_usec);
		if (_relay->heard_usec() > 0 || _relay->state() == ClientRelay::State::FAILED) {
			(_relay->heard_usec() > 0 ? opened : refused)++;
			_relay.reset();
			_next_usec = p_now_usec + HONEST_USEC;
		}
	}

	std::atomic<uint64_t> opened{ 0 };
	std::atomic<uint64_t> refused{ 0 };

private:
	uint16_t _server;
	Bytes _password;
	std::unique_ptr<Port> _port;
	std::unique_ptr<ClientRelay> _relay;
	Bytes _bytes;
	int64_t _next_usec = 0;
};

/// An honest client beside an attack, in a thread: the attack must not keep it from its own work.
class Beside {
public:
	Beside(uint16_t p_server, const std::string &p_password) : _honest(p_server, p_password) {
		_thread = std::thread([this] {
			while (!_over) {
				_honest.go_on(now_usec());
				std::this_thread::sleep_for(std::chrono::microseconds(500));
			}
		});
	}
	~Beside() {
		_over = true;
		_thread.join();
	}
	Beside(const Beside &) = delete;
	Beside &operator=(const Beside &) = delete;

	uint64_t opened() const { return _honest.opened; }
	uint64_t refused() const { return _honest.refused; }

private:
	Honest _honest;
	std::atomic<bool> _over{ false };
	std::thread _thread;
};

int half_open(uint16_t p_server, double p_rate, uint64_t p_honest, const std::string &p_address,
		const std::string &p_password) {
	std::vector<std::unique_ptr<Port>> ports;
	ports.reserve(PORTS);
	const int readable = epoll_create1(EPOLL_CLOEXEC);
	for (size_t i = 0; i < PORTS; i++) {
		ports.push_back(std::make_unique<Port>(p_address, p_server));
		ports.back()->watch(readable, uint32_t(i));
	}
	std::mt19937_64 random(7);
	messages::Init init;
	init.version = VERSION;
	messages::Start start;
	start.version = VERSION;
	start.share = cpace::share_of(cpace::sample_scalar(), cpace::generator({})).value_or(cpace::Share());
	Beside honest(p_server, p_password);
	uint64_t begun = 0;
	uint64_t started = 0;
	uint64_t answered = 0;
	Bytes bytes;
	const int64_t begin = now_usec();
	for (int64_t now = begin; honest.opened() < p_honest && now < begin + PATIENCE_USEC; now = now_usec()) {
		for (; double(begun) < double(now - begin) / 1e6 * p_rate; begun++) {
			const uint64_t id = random();
			std::memcpy(init.client.data(), &id, sizeof(id));
			ports[begun % PORTS]->write(init.encode());
		}
		std::array<epoll_event, PORTS> events{};
		const int count = epoll_wait(readable, events.data(), int(events.size()), 0);
		for (int i = 0; i < count; i++) {
			const std::unique_ptr<Port> &port = ports[events[size_t(i)].data.u32];
			while (port->read(bytes)) {
				messages::CookieReply reply;
				if (reply.decode(bytes)) {
					start.client = reply.client;
					start.cookie = reply.cookie;
					port->write(start.encode());
					started++;
				} else {
					answered++;
				}
			}
		}
		std::this_thread::sleep_for(std::chrono::microseconds(500));
	}
	close(readable);
	std::printf("{\"begun\": %llu, \"started\": %llu, \"answered\": %llu, \"opened\": %llu, \"refused\": %llu}\n",
			static_cast<unsigned long long>(begun), static_cast<unsigned long long>(started),
			static_cast<unsigned long long>(answered), static_cast<unsigned long long>(honest.opened()),
			static_cast<unsigned long long>(honest.refused()));
	return honest.opened() < p_honest ? 1 : 0;
}

/// One guess after the other from one port.
class Guesser {
public:
	Guesser(const std::string &p_address, uint16_t p_server) : _port(p_address, p_server) {}

	/// Returns whether a guess has been answered.
	bool go_on(int64_t p_now_usec, uint64_t p_number) {
		if (!_relay) {
			ClientRelay::Settings settings;
			settings.version = VERSION;
			const std::string password = "guess " + std::to_string(p_number);
			settings.password = Bytes(password.begin(), password.end());
			_relay = std::make_unique<ClientRelay>(
					settings, [this](const View &p_bytes) { _port.write(p_bytes); }, [](const View &) {},
					[](const View &) {});
		}
		bool is_answered = false;
		while (_port.read(_bytes)) {
			is_answered = is_answered || (!_bytes.empty() && _bytes[0] == messages::REPLY);
			// A reply lets the proof out at once.
			_relay->take_outer(_bytes, p_now_usec);
		}
		_relay->look_after(p_now_usec);
		if (is_answered) {
			_relay.reset();
		}
		return is_answered;
	}

private:
	Port _port;
	std::unique_ptr<ClientRelay> _relay;
	Bytes _bytes;
};

int guess(uint16_t p_server, uint64_t p_honest, const std::string &p_address, const std::string &p_password) {
	std::vector<std::unique_ptr<Guesser>> guessers;
	guessers.reserve(GUESSERS);
	for (size_t i = 0; i < GUESSERS; i++) {
		guessers.push_back(std::make_unique<Guesser>(p_address, p_server));
	}
	Beside honest(p_server, p_password);
	uint64_t answered = 0;
	const int64_t begin = now_usec();
	int64_t now = begin;
	for (; honest.opened() < p_honest && now < begin + PATIENCE_USEC; now = now_usec()) {
		for (const std::unique_ptr<Guesser> &each : guessers) {
			answered += each->go_on(now, answered) ? 1 : 0;
		}
		std::this_thread::sleep_for(std::chrono::microseconds(500));
	}
	std::printf("{\"answered\": %llu, \"seconds\": %.3f, \"opened\": %llu, \"refused\": %llu}\n",
			static_cast<unsigned long long>(answered), double(now - begin) / 1e6,
			static_cast<unsigned long long>(honest.opened()), static_cast<unsigned long long>(honest.refused()));
	return honest.opened() < p_honest ? 1 : 0;
}

int forged(uint16_t p_server, uint64_t p_count, const std::string &p_address) {
	const Port port(p_address, p_server);
	std::mt19937_64 random(8);
	Bytes bytes;
	for (uint64_t i = 0; i < p_count; i++) {
		bytes.resize(1 + random() % 200);
		for (uint8_t &byte : bytes) {
			byte = uint8_t(random());
		}
		bytes[0] = uint8_t(random() % 3 == 0 ? 0x80 + random() % 128 : 0x40 + random() % 12);
		port.write(bytes);
		if (i % 50 == 49) {
			std::this_thread::sleep_for(std::chrono::milliseconds(1));
		}
	}
	std::printf("{\"sent\": %llu}\n", static_cast<unsigned long long>(p_count));
	return 0;
}

} // namespace

int main(int p_count, char **p_arguments) {
	const std::vector<std::string> arguments(p_arguments + 1, p_arguments + p_count);
	if ((arguments.size() == 5 || arguments.size() == 6) && arguments[0] == "half-open") {
		return half_open(uint16_t(std::stoi(arguments[1])), std::stod(arguments[2]), std::stoull(arguments[3]),
				arguments[4], arguments.size() == 6 ? arguments[5] : "");
	}
	if (arguments.size() == 5 && arguments[0] == "guess") {
		return guess(uint16_t(std::stoi(arguments[1])), std::stoull(arguments[2]), arguments[3], arguments[4]);
	}
	if (arguments.size() == 4 && arguments[0] == "forged") {
		return forged(uint16_t(std::stoi(arguments[1])), std::stoull(arguments[2]), arguments[3]);
	}
	std::fputs("transport_flood half-open PORT RATE HONEST ADDRESS [PASSWORD] | guess PORT HONEST ADDRESS PASSWORD |\n"
			   "  forged PORT COUNT ADDRESS\n",
			stderr);
	return 2;
}
