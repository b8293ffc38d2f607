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
	init.version = 7;
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
	server.seal(Content::ENET, ascii("hello"), data);
	CHECK(equal(init.encode(),
			hex("4144534d5407000000010102030405060708000000000000000000000000000000000000000000000000"
				"00000000000000000000000000000000000000000000")));
	CHECK(equal(cookie.encode(), hex("420102030405060708101112131415161718191a1b1c1d1e1f01")));
	CHECK(equal(channel, hex("0f4469736d6f756e7420636c69656e740f4469736d6f756e7420736572766572")));
	CHECK(equal(generator, hex("0676e5128ee95a8cb84e36d6d4b1743ef14ba2d6c4efcedfa70a2b536f07c55f")));
	CHECK(equal(start.encode(),
			hex("430102030405060708101112131415161718191a1b1c1d1e1f0700000001000000000000000000000000"
				"0000000046eb0599e8308fbcde4bdc5e7cae7b8fa0cf454bf03e1002daa94296ff81f16b")));
	CHECK(equal(
			reply.encode(), hex("4401020304050607089e1126c4197e5e6aa834f518bc1290fdca34728abd05d82467cfbd1cdfc9666b")));
	CHECK(equal(key,
			hex("e7fde128295452bb14f713cb04b6b6f0eb0be5566a6236cb980914fca558c6b6ff1b8b86d72f5aac95a1"
				"7e79b1e4b55adceb58d7c43c0c81e26411f732c6a5ce")));
	CHECK(equal(keys.to_server, hex("f18395419e97830d39f471ce92a50a7d9a7da0deb763a703053efa219e801ac9")));
	CHECK(equal(keys.to_client, hex("76153dcbd3c3e1a6be4ebe50706e19894899eb060acc6916c8076facbd38a35f")));
	CHECK(equal(keys.exporter, hex("8e7283af21880aa9382b2c066a237635414fa2c1cab46a6a112af601762ac1a3")));
	CHECK(equal(keys.return_tag, hex("b45a97872a7829ac1969c2979d99b335")));
	CHECK(equal(first, hex("460102030405060708000000be8e065f00524dd021cb76e848dd7449")));
	CHECK(equal(data, hex("8000ba113135cb3de7147cf6d31c4def9dae44841dab70")));
}

} // namespace test_protocol_example
