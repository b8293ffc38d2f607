// SPDX-License-Identifier: MIT
// The receiver behind a real socket of this machine.
#include "drawn_content.hpp"

#include "udp/receiver.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <check.hpp>

#include <chrono>
#include <functional>

namespace test_receiver {

using namespace drawn;

namespace {

class Sender {
public:
	explicit Sender(uint16_t p_port) : _socket(socket(AF_INET, SOCK_DGRAM, 0)) {
		_to.sin_family = AF_INET;
		_to.sin_port = htons(p_port);
		_to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
	}
	Sender(const Sender &) = delete;
	Sender &operator=(const Sender &) = delete;
	~Sender() { close(_socket); }

	void send(const Bytes &p_bytes) {
		sendto(_socket, p_bytes.data(), p_bytes.size(), 0, reinterpret_cast<const sockaddr *>(&_to), sizeof(_to));
	}
	void send(const Content &p_content) {
		for (const Bytes &bytes : encode(p_content)) {
			send(bytes);
		}
	}

private:
	int _socket;
	sockaddr_in _to{};
};

/// Waits until something holds, long enough for any machine.
bool comes(const std::function<bool()> &p_holds) {
	for (int round = 0; round < 4000; ++round) {
		if (p_holds()) {
			return true;
		}
		std::this_thread::sleep_for(std::chrono::milliseconds(5));
	}
	return false;
}

bool has_message(Receiver &r_receiver, std::vector<std::string> &r_heard, const char *p_part) {
	for (std::string &text : r_receiver.take_messages()) {
		r_heard.push_back(std::move(text));
	}
	for (const std::string &text : r_heard) {
		if (text.find(p_part) != std::string::npos) {
			return true;
		}
	}
	return false;
}

} // namespace

TEST(samples_come_through_a_socket_as_they_were_sent) {
	Receiver receiver;
	CHECK(receiver.open(0).empty());
	CHECK(receiver.port() != 0);
	Sender sender(receiver.port());
	Source source(1);
	std::vector<Content> sent;
	for (uint32_t number = 0; number < 30; ++number) {
		sent.push_back(source.content(Type::POSE, number, true));
		sender.send(sent.back());
	}
	Content meta = source.content(Type::META, 1);
	meta.tags[0].second = "Eve";
	sender.send(meta);
	CHECK(comes([&]() {
		const ReceiverReport report = receiver.report();
		return report.characters.size() == 1 && report.characters[0].name == "Eve";
	}));
	const std::vector<ReceivedSample> got = receiver.take_samples(0, Type::POSE);
	CHECK(got.size() == sent.size());
	for (std::size_t at = 0; at < std::min(got.size(), sent.size()); ++at) {
		CHECK(same(got[at].content, sent[at]) && got[at].arrival_usec > 0);
	}
	CHECK(receiver.take_samples(0, Type::POSE).empty());
	ReceivedSample newest;
	CHECK(receiver.newest(0, Type::POSE, newest) && same(newest.content, sent.back()));
	CHECK(!receiver.newest(0, Type::SCALE, newest) && !receiver.newest(9, Type::POSE, newest));
}

TEST(a_port_in_use_is_reported_with_its_number) {
	Receiver first;
	CHECK(first.open(0).empty());
	Receiver second;
	const std::string fault = second.open(first.port());
	CHECK(fault.find(std::to_string(first.port())) != std::string::npos);
	CHECK(fault.find("in use") != std::string::npos);
	CHECK(second.port() == 0);
	first.close();
	CHECK(second.open(0).empty());
}

TEST(bad_datagrams_are_reported_with_sender_and_reason) {
	Receiver receiver;
	receiver.open(0);
	Sender sender(receiver.port());
	Source source(2);
	Bytes bad = encode(source.content(Type::POSE, 1))[0];
	bad[11] = 255;
	bad[22] = bad[23] = 0;
	bad.resize(HEADER_SIZE + 255 * 32);
	sender.send(Bytes());
	sender.send(bad);
	sender.send(Bytes(9000, 'x'));
	sender.send(source.content(Type::POSE, 2));
	std::vector<std::string> heard;
	CHECK(comes([&]() { return receiver.report().characters.size() == 1; }));
	CHECK(has_message(receiver, heard, "more segments than a character has"));
	CHECK(has_message(receiver, heard, "127.0.0.1:"));
	CHECK(has_message(receiver, heard, "not of MVN's form"));
	const ReceiverReport report = receiver.report();
	CHECK(report.datagrams == 4);
	CHECK(report.refused[std::size_t(Fault::TOO_MANY)] == 1 && report.refused[std::size_t(Fault::TOO_SHORT)] == 1);
}

TEST(a_character_of_two_senders_is_reported_with_both) {
	Receiver receiver;
	receiver.open(0);
	Sender first(receiver.port());
	Sender second(receiver.port());
	Source source(3);
	first.send(source.content(Type::POSE, 1));
	CHECK(comes([&]() { return receiver.report().characters.size() == 1; }));
	second.send(source.content(Type::POSE, 1));
	std::vector<std::string> heard;
	CHECK(comes([&]() { return has_message(receiver, heard, "two senders"); }));
	CHECK(receiver.report().characters[0].trouble.find("character 0") != std::string::npos);
}

TEST(two_people_with_one_number_are_noticed_and_the_trouble_passes) {
	for (const uint32_t apart : { 0U, 100000U }) {
		Receiver receiver;
		Source source(4);
		uint64_t now = 1000000;
		const auto play = [&](uint32_t p_begin, bool p_is_double) {
			for (uint32_t number = p_begin; number < p_begin + 150; ++number) {
				now += 10000;
				const Bytes one = encode(source.content(Type::POSE, number))[0];
				receiver.take("10.0.0.5:4000", one.data(), one.size(), now);
				if (p_is_double) {
					const Bytes other = encode(source.content(Type::POSE, number + apart))[0];
					receiver.take("10.0.0.5:4000", other.data(), other.size(), now + 100);
				}
			}
		};
		play(0, false);
		CHECK(receiver.report().characters.at(0).trouble.empty());
		play(150, true);
		CHECK(receiver.report().characters.at(0).trouble.find("comes twice") != std::string::npos);
		play(300, false);
		CHECK(receiver.report().characters.at(0).trouble.empty());
	}
}

TEST(who_is_silent_leaves) {
	Receiver receiver;
	Source source(5);
	const Bytes one = encode(source.content(Type::POSE, 1))[0];
	receiver.take("a", one.data(), one.size(), 1000000);
	CHECK(receiver.report().characters.size() == 1);
	Content other = source.content(Type::POSE, 1);
	other.header.character = 3;
	const Bytes later = encode(other)[0];
	receiver.take("a", later.data(), later.size(), 9000000);
	CHECK(receiver.report().characters.size() == 1);
	CHECK(receiver.report().characters.at(0).number == 3);
	const std::vector<std::string> news = receiver.take_news();
	CHECK(news.size() == 3 && news[0] == "character 0 comes from a" && news[2] == "character 0 comes no more");
	CHECK(receiver.take_news().empty() && receiver.take_messages().empty());
}

} // namespace test_receiver
