// SPDX-License-Identifier: MIT
#include "check.hpp"
#include "discovery/open_questions.hpp"
#include "wire.hpp"

#include <random>

/// Clients that look for servers, and what others make of the questions and the answers.
namespace test_discovery {

using namespace wire;

const discovery::Nonce NONCE{ { 1, 2, 3, 4, 5, 6, 7, 8 } };

struct Scene {
	Net net;
	Endpoint asker = endpoint("192.0.2.1", 4000);

	explicit Scene(bool p_seals = true, const Bytes &p_body = ascii("here I am")) :
			net(server_settings("secret", p_seals)) {
		net.server.set_announcement(p_body);
	}
	void ask(const Bytes &p_question) { net.server.take_outer(asker, p_question, net.now, net.record); }
};

TEST(a_question_is_answered_sealed_or_not_and_nothing_is_kept) {
	for (const bool seals : { true, false }) {
		Scene scene(seals);
		scene.ask(discovery::make_question(NONCE));
		CHECK(scene.net.record.outer.size() == 1 && scene.net.record.outer.front().to == scene.asker);
		const Bytes answer = scene.net.record.outer.front().bytes;
		discovery::Nonce nonce{};
		CHECK(discovery::read_answer(answer, nonce) && nonce == NONCE);
		CHECK(Bytes(answer.begin() + discovery::ANSWER_HEAD, answer.end()) == ascii("here I am"));
		CHECK(scene.net.server.links().half_open() == 0 && scene.net.server.pending() == 0);
		CHECK(scene.net.record.inner.empty());
	}
}

TEST(no_answer_is_longer_than_its_question) {
	for (size_t size = 0; size < 600; size++) {
		Scene scene(true, {});
		const bool fits = scene.net.server.set_announcement(Bytes(size, 'x'));
		CHECK(fits == (size <= discovery::MAX_BODY));
		const Bytes question = discovery::make_question(NONCE);
		scene.ask(question);
		CHECK(scene.net.record.outer.size() == (fits && size > 0 ? 1U : 0U));
		for (const Sent &sent : scene.net.record.outer) {
			CHECK(sent.bytes.size() <= question.size());
		}
	}
}

TEST(what_is_no_question_is_not_answered_and_not_believed) {
	Scene scene;
	const Bytes good = discovery::make_question(NONCE);
	for (size_t size = 0; size < 1500; size++) {
		Bytes bad = good;
		bad.resize(size);
		if (size != good.size()) {
			scene.ask(bad);
		}
	}
	CHECK(scene.net.record.outer.empty() && scene.net.server.counts().questions == 0);
	std::mt19937 random(4);
	for (int i = 0; i < 20000; i++, scene.net.now += 1000) {
		Bytes bad = good;
		for (int change = 0; change < 1 + i % 4; change++) {
			bad[random() % 14] = uint8_t(random());
		}
		scene.ask(bad);
	}
	for (const Sent &sent : scene.net.record.outer) {
		CHECK(sent.bytes.size() <= good.size());
	}
	// Questions alone make no links, whatever was altered.
	CHECK(scene.net.server.links().confirmed() == 0 && scene.net.record.inner.empty());
}

TEST(so_many_are_answered_a_second_and_no_more) {
	Scene scene;
	scene.net.record.keeps = false;
	const Bytes question = discovery::make_question(NONCE);
	for (int i = 0; i < 20000; i++, scene.net.now += 250) {
		scene.ask(question);
	}
	const uint64_t of_one = scene.net.server.counts().answers;
	CHECK(of_one > 200 && of_one < 400);
	for (int i = 0; i < 100000; i++, scene.net.now += 50) {
		scene.asker.address[15] = uint8_t(i);
		scene.asker.address[14] = uint8_t(i >> 8);
		scene.ask(question);
	}
	const uint64_t of_all = scene.net.server.counts().answers - of_one;
	CHECK(of_all > 4000 && of_all < 7000);
	CHECK(scene.net.server.counts().questions == 120000);
}

TEST(an_answer_is_of_a_question_that_was_asked_there) {
	OpenQuestions open;
	const Endpoint server = endpoint("192.0.2.9", 7777);
	const Endpoint all = endpoint("192.0.2.255", 7778);
	const discovery::Nonce other{ { 9 } };
	open.note(NONCE, server, true, 1000);
	open.note(other, all, false, 2000);
	const Bytes answer = discovery::make_answer(NONCE, ascii("a"));
	const Bytes of_all = discovery::make_answer(other, ascii("b"));
	CHECK(open.take(answer, server, 5000) == 4000);
	CHECK(open.take(answer, server, 6000) == 5000);
	CHECK(open.take(answer, endpoint("192.0.2.8", 7777), 5000) < 0);
	CHECK(open.take(answer, endpoint("192.0.2.9", 7778), 5000) < 0);
	CHECK(open.take(of_all, endpoint("192.0.2.8", 7778), 5000) == 3000);
	CHECK(open.take(of_all, endpoint("192.0.2.8", 7777), 5000) < 0);
	// Too late, or before it was asked, as after a clock was set.
	CHECK(open.take(answer, server, 1000 + OpenQuestions::OPEN_USEC + 1) < 0);
	CHECK(open.take(answer, server, 999) < 0);
	for (uint64_t i = 0; i < 10000; i++) {
		discovery::Nonce nonce{};
		std::memcpy(nonce.data(), &i, sizeof(i));
		open.note(nonce, server, true, 3000);
	}
	CHECK(open.size() <= OpenQuestions::MAX);
	open.note(other, server, true, 10 * SECOND);
	CHECK(open.size() == 1);
}

TEST(forged_answers_open_nothing) {
	OpenQuestions open;
	const Endpoint server = endpoint("192.0.2.9", 7777);
	open.note(NONCE, server, true, 1000);
	std::mt19937 random(6);
	for (int i = 0; i < 100000; i++) {
		Bytes forged(random() % 600);
		for (uint8_t &byte : forged) {
			byte = uint8_t(random());
		}
		if (!forged.empty()) {
			forged[0] = discovery::ANSWER;
		}
		CHECK(open.take(forged, server, 5000) < 0);
	}
}

} // namespace test_discovery
