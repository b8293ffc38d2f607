// SPDX-License-Identifier: MIT
#pragma once

#include "hex.hpp"
#include "relay/client_relay.hpp"
#include "relay/server_relay.hpp"

#include <deque>

/// A server's relay and its clients' without sockets: what they send waits in queues.
namespace wire {

using namespace transport;

constexpr int64_t SECOND = 1000000;

inline Endpoint endpoint(const std::string &p_address, uint16_t p_port) {
	Endpoint made;
	made.parse(p_address, p_port);
	return made;
}

struct Sent {
	Endpoint to;
	Bytes bytes;
};

struct Inner {
	uint32_t from = 0;
	Bytes bytes;
};

/// What the server's relay has sent.
class Record : public RelaySink {
public:
	std::deque<Sent> outer;
	std::deque<Inner> inner;
	/// Messages beside ENet, by the name of their client.
	std::deque<std::pair<int64_t, Bytes>> fast;
	bool keeps = true;

	void to_outer(const Endpoint &p_to, const View &p_bytes) override {
		if (keeps) {
			outer.push_back({ p_to, Bytes(p_bytes.data, p_bytes.data + p_bytes.size) });
		}
	}
	void to_inner(uint32_t p_from, const View &p_bytes) override {
		inner.push_back({ p_from, Bytes(p_bytes.data, p_bytes.data + p_bytes.size) });
	}
	void to_program(int64_t p_peer, const View &p_bytes) override {
		fast.push_back({ p_peer, Bytes(p_bytes.data, p_bytes.data + p_bytes.size) });
	}
};

inline Bytes ascii(const std::string &p_text) {
	return { p_text.begin(), p_text.end() };
}

inline void append_big(Bytes &r_bytes, uint32_t p_value, int p_bytes) {
	for (int i = p_bytes - 1; i >= 0; i--) {
		r_bytes.push_back(uint8_t(p_value >> (8 * i)));
	}
}

/// ENet's head and the beginning of a command.
inline Bytes command(uint16_t p_peer, uint8_t p_kind, uint8_t p_channel, uint16_t p_number) {
	Bytes made;
	append_big(made, 0x8000U | p_peer, 2);
	append_big(made, 0, 2);
	made.push_back(p_kind | 0x80);
	made.push_back(p_channel);
	append_big(made, p_number, 2);
	return made;
}

inline Bytes enet_connect(uint32_t p_channels = 8, uint64_t p_chosen = 0x0102030405060708) {
	Bytes made = command(0xFFF, 2, 0xFF, 1);
	append_big(made, 0, 2);
	append_big(made, 0xFFFF, 2);
	append_big(made, 1400, 4);
	append_big(made, 65536, 4);
	append_big(made, p_channels, 4);
	made.resize(made.size() + 20);
	append_big(made, uint32_t(p_chosen >> 32), 4);
	append_big(made, uint32_t(p_chosen), 4);
	return made;
}

/// ENet's answer: its peer, and the session of what the client sends from then on.
inline Bytes enet_verify(uint16_t p_peer, uint8_t p_session) {
	Bytes made = command(0, 3, 0xFF, 1);
	append_big(made, p_peer, 2);
	made.push_back(0);
	made.push_back(p_session);
	made.resize(made.size() + 36);
	return made;
}

inline Bytes enet_acknowledge(uint16_t p_peer, uint8_t p_channel, uint16_t p_number) {
	Bytes made = command(p_peer, 1, p_channel, 0);
	append_big(made, p_number, 2);
	append_big(made, 0, 2);
	return made;
}

inline Bytes enet_reliable(uint8_t p_channel, uint16_t p_number, size_t p_size) {
	Bytes made = command(0, 6, p_channel, p_number);
	append_big(made, uint32_t(p_size), 2);
	made.resize(made.size() + p_size);
	return made;
}

inline Bytes enet_fragment(uint16_t p_first, uint32_t p_count, uint32_t p_index, uint32_t p_whole, uint32_t p_part) {
	const uint32_t offset = p_index * p_part;
	const uint32_t size = p_index + 1 == p_count ? p_whole - offset : p_part;
	Bytes made = command(0, 8, 0, uint16_t(p_first + p_index));
	append_big(made, p_first, 2);
	append_big(made, size, 2);
	append_big(made, p_count, 4);
	append_big(made, p_index, 4);
	append_big(made, p_whole, 4);
	append_big(made, offset, 4);
	made.resize(made.size() + size);
	return made;
}

inline ServerRelay::Settings server_settings(const std::string &p_password = "", bool p_seals = true) {
	ServerRelay::Settings made;
	made.seals = p_seals;
	made.version = 5;
	made.passwords.fill(ascii(p_password));
	made.limits.bounded = true;
	made.limits.min_channels = 8;
	return made;
}

inline ClientRelay::Settings client_settings(const std::string &p_password = "", bool p_seals = true) {
	ClientRelay::Settings made;
	made.seals = p_seals;
	made.version = 5;
	made.role = 1;
	made.password = ascii(p_password);
	return made;
}

/// One client with what it has been sent for its ENet and what waits for the network.
struct Client {
	Endpoint at;
	std::deque<Bytes> out;
	std::deque<Bytes> inner;
	std::deque<Bytes> fast;
	ClientRelay relay;

	explicit Client(const Endpoint &p_at, ClientRelay::Settings p_settings) :
			at(p_at),
			relay(
					std::move(p_settings),
					[this](const View &p_bytes) { out.push_back(Bytes(p_bytes.data, p_bytes.data + p_bytes.size)); },
					[this](const View &p_bytes) { inner.push_back(Bytes(p_bytes.data, p_bytes.data + p_bytes.size)); },
					[this](const View &p_bytes) { fast.push_back(Bytes(p_bytes.data, p_bytes.data + p_bytes.size)); }) {
	}
};

/// A server and the time. What is larger than the network carries, in either direction, is lost.
struct Net {
	ServerRelay server;
	Record record;
	int64_t now = 1000000;
	std::vector<Client *> clients;
	size_t mtu = SIZE_MAX;

	explicit Net(ServerRelay::Settings p_settings) : server(std::move(p_settings)) {}

	/// Hands over what waits, in both directions, until nothing does.
	void exchange() {
		for (bool more = true; more;) {
			more = false;
			for (Client *client : clients) {
				while (!client->out.empty()) {
					const Bytes bytes = client->out.front();
					client->out.pop_front();
					if (bytes.size() <= mtu) {
						server.take_outer(client->at, bytes, now, record);
					}
					more = true;
				}
			}
			while (!record.outer.empty()) {
				const Sent sent = record.outer.front();
				record.outer.pop_front();
				for (Client *client : clients) {
					if (client->at == sent.to && sent.bytes.size() <= mtu) {
						client->relay.take_outer(sent.bytes, now);
					}
				}
				more = true;
			}
		}
	}

	/// Lets time go on.
	void run(int64_t p_usec) {
		for (const int64_t end = now + p_usec; now < end; now += 10000) {
			for (Client *client : clients) {
				client->relay.look_after(now);
			}
			exchange();
			server.look_after(now, record);
		}
	}
};

/// Connects a client's ENet, as far as the relay can see. Returns where it stands for ENet.
inline uint32_t connect_enet(Net &r_net, Client &r_client, uint16_t p_peer = 7) {
	r_client.relay.take_inner(enet_connect());
	r_net.exchange();
	const uint32_t inner = r_net.record.inner.back().from;
	r_net.server.take_inner(inner, enet_verify(p_peer, 2), r_net.now, r_net.record);
	r_net.exchange();
	r_client.relay.take_inner(enet_acknowledge(p_peer, 0xFF, 1));
	r_net.exchange();
	return inner;
}

inline bool is_open(const Client &p_client) {
	return p_client.relay.state() == ClientRelay::State::OPEN;
}

} // namespace wire
