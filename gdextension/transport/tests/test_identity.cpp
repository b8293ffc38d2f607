// SPDX-License-Identifier: MIT
#include "check.hpp"
#include "wire.hpp"

namespace test_identity {

using namespace wire;

namespace {

Endpoint at(uint16_t p_port) {
	Endpoint made;
	made.parse("127.0.0.1", p_port);
	return made;
}

Identity identity_of(uint8_t p_byte) {
	Key seed;
	seed.fill(p_byte);
	return Identity(seed);
}

} // namespace

TEST(a_proof_is_good_for_its_handshake_alone) {
	const Identity identity = identity_of(1);
	Key exporter;
	exporter.fill(9);
	Bytes proof = identity.prove(exporter);
	Key shown{};
	CHECK(Identity::check(proof, exporter, shown) && shown == identity.public_key());
	Key other = exporter;
	other[0] ^= 1;
	CHECK(!Identity::check(proof, other, shown));
	proof[40] ^= 1;
	CHECK(!Identity::check(proof, exporter, shown));
	CHECK(!Identity::check(View(), exporter, shown));
	CHECK(identity_of(2).public_key() != identity.public_key());
	CHECK(Identity().public_key() != Identity().public_key());
}

TEST(a_client_takes_any_key_unless_it_knows_one) {
	for (const bool knows : { false, true }) {
		ServerRelay::Settings server = server_settings();
		server.identity = identity_of(1);
		Net net(server);
		ClientRelay::Settings settings = client_settings();
		if (knows) {
			settings.known_key = identity_of(1).public_key();
		}
		Client client(at(5001), settings);
		net.clients = { &client };
		net.run(200000);
		connect_enet(net, client);
		CHECK(is_open(client) && client.relay.server_key() == identity_of(1).public_key());
		CHECK(net.record.inner.size() == 2);
	}
}

TEST(another_key_than_the_known_one_is_refused) {
	for (const bool was_here : { false, true }) {
		ServerRelay::Settings server = server_settings();
		server.identity = identity_of(2);
		Net net(server);
		ClientRelay::Settings settings = client_settings();
		settings.known_key = identity_of(1).public_key();
		settings.return_tag.fill(was_here ? 5 : 0);
		Client client(at(5001), settings);
		net.clients = { &client };
		net.run(6000000);
		CHECK(client.relay.state() == ClientRelay::State::FAILED);
		CHECK(client.relay.notice() == ClientRelay::OTHER_KEY);
		CHECK(client.relay.server_key() == identity_of(2).public_key());
		CHECK(client.inner.empty());
	}
}

TEST(a_password_proves_more_than_a_key) {
	ServerRelay::Settings server = server_settings("open sesame");
	server.identity = identity_of(2);
	Net net(server);
	ClientRelay::Settings settings = client_settings("open sesame");
	settings.known_key = identity_of(1).public_key();
	Client client(at(5001), settings);
	net.clients = { &client };
	net.run(200000);
	CHECK(is_open(client) && client.relay.server_key() == identity_of(2).public_key());
}

} // namespace test_identity
