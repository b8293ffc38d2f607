// SPDX-License-Identifier: MIT
// The worked handshake of docs/protocol.md, "Sealing": every value of it.
#include "check.hpp"
#include "hex.hpp"
#include "sealing/messages.hpp"
#include "sealing/sealed_channel.hpp"

namespace test_protocol_example {

using namespace transport;

namespace {

Bytes ascii(const std::string &p_text) {
	return { p_text.begin(), p_text.end() };
}

} // namespace

TEST(the_handshake_of_the_protocol) {
	messages::Init init;
	init.version = 5;
	init.role = 1;
	init.client = hex_array<8>("0102030405060708");
	messages::CookieReply cookie;
	cookie.client = init.client;
	cookie.cookie = hex_array<16>("101112131415161718191a1b1c1d1e1f");
	cookie.locked = true;
	const Bytes password = ascii("open sesame");
	const Bytes channel = messages::channel_identifier();
	const Bytes session = messages::session_identifier(init.client, cookie.cookie);
	const auto generator = cpace::generator({ password, channel, session });
	// The scalars of the draft's own vectors.
	const auto ya = hex_array<32>("da3d23700a9e5699258aef94dc060dfda5ebb61f02a5ea77fad53f4ff0976d08");
	const auto yb = hex_array<32>("d2316b454718c35362d83d69df6320f38578ed5984651435e2949762d900b80d");
	messages::Start start;
	start.client = init.client;
	start.cookie = cookie.cookie;
	start.version = init.version;
	start.role = init.role;
	start.share = cpace::share_of(ya, generator).value_or(cpace::Share());
	messages::Reply reply;
	reply.client = init.client;
	reply.share = cpace::share_of(yb, generator).value_or(cpace::Share());
	const Bytes associated = start.associated();
	const auto key = cpace::session_key(yb, start.share, session, { start.share, associated }, { reply.share, View() })
							 .value_or(cpace::SessionKey());
	CHECK(cpace::session_key(ya, reply.share, session, { start.share, associated }, { reply.share, View() }) == key);
	const ChannelKeys keys = ChannelKeys::derive(key);
	SealedChannel client(keys.to_server, keys.to_client);
	SealedChannel server(keys.to_client, keys.to_server);
	Bytes first;
	client.seal(messages::first_head(init.client), View(), first);
	Bytes data;
	server.seal(Bytes{ messages::DATA }, ascii("hello"), data);
	CHECK(equal(init.encode(),
			hex("4144534d54050000000101020304050607080000000000000000000000000000000000000000000000000000"
				"0000000000000000000000000000000000000000")));
	CHECK(equal(cookie.encode(), hex("420102030405060708101112131415161718191a1b1c1d1e1f01")));
	CHECK(equal(channel, hex("0f4469736d6f756e7420636c69656e740f4469736d6f756e7420736572766572")));
	CHECK(equal(generator, hex("0676e5128ee95a8cb84e36d6d4b1743ef14ba2d6c4efcedfa70a2b536f07c55f")));
	CHECK(equal(start.encode(),
			hex("430102030405060708101112131415161718191a1b1c1d1e1f05000000010000000000000000000000000000"
				"000046eb0599e8308fbcde4bdc5e7cae7b8fa0cf454bf03e1002daa94296ff81f16b")));
	CHECK(equal(
			reply.encode(), hex("4401020304050607089e1126c4197e5e6aa834f518bc1290fdca34728abd05d82467cfbd1cdfc9666b")));
	CHECK(equal(key,
			hex("dcddf80f036b4b255b5b662a021e6529ecaf3b519a4efd0593cc2f08a1fe00dde2a13d44e286ad71f5393f49"
				"eaf185f51d1f41464c4cbd4e0e971d5563780b05")));
	CHECK(equal(keys.to_server, hex("ce6c3bbf595a7e453dffb143d3ef376b9036a31becc7a381299039375a28c5ca")));
	CHECK(equal(keys.to_client, hex("9a35a533a873f71b19610aa46f377e9e6fb3bb32dcc2c7d243bb810c631028f4")));
	CHECK(equal(keys.exporter, hex("e1c0b457228e6509f6699a0c8e8f7690ea25e8aa051aa01c61bf83dd54349605")));
	CHECK(equal(keys.return_tag, hex("73e4727eb521e83264b73f35937d7d05")));
	CHECK(equal(first, hex("460102030405060708000000cd3185d928d7f916352f6f25d48f7ef9")));
	CHECK(equal(data, hex("4700000024dc79ffb4e18139a0d9e2bb76d23a58b81233de23")));
}

} // namespace test_protocol_example
