// SPDX-License-Identifier: MIT
#include "messages.hpp"

namespace transport::messages {

namespace {

constexpr std::array<uint8_t, 4> MAGIC{ { 'D', 'S', 'M', 'T' } };
constexpr size_t COOKIE_SIZE = 26;
constexpr size_t START_SIZE = 78;
constexpr size_t REPLY_SIZE = 41;
constexpr size_t NOTICE_SIZE = 14;
constexpr size_t UNKNOWN_SIZE = 17;

Bytes begin(Type p_type, const ClientId &p_client) {
	Bytes made{ p_type };
	append(made, p_client);
	return made;
}

bool is(const View &p_bytes, Type p_type, size_t p_size) {
	return p_bytes.size == p_size && p_bytes.data[0] == p_type;
}

void append_text(Bytes &r_bytes, const char *p_text) {
	cpace::append_with_length(r_bytes, { reinterpret_cast<const uint8_t *>(p_text), std::strlen(p_text) });
}

} // namespace

Bytes Init::encode() const {
	Bytes made{ INIT };
	append(made, MAGIC);
	append_u32(made, version);
	made.push_back(role);
	append(made, client);
	made.resize(INIT_SIZE);
	return made;
}

bool Init::decode(const View &p_bytes) {
	if (!is(p_bytes, INIT, INIT_SIZE) || read_array<4>(p_bytes.data + 1) != MAGIC) {
		return false;
	}
	version = read_u32(p_bytes.data + 5);
	role = p_bytes.data[9];
	client = read_array<8>(p_bytes.data + 10);
	return true;
}

Bytes CookieReply::encode() const {
	Bytes made = begin(COOKIE, client);
	append(made, cookie);
	made.push_back(locked ? 1 : 0);
	return made;
}

bool CookieReply::decode(const View &p_bytes) {
	if (!is(p_bytes, COOKIE, COOKIE_SIZE) || p_bytes.data[25] > 1) {
		return false;
	}
	client = read_array<8>(p_bytes.data + 1);
	cookie = read_array<16>(p_bytes.data + 9);
	locked = p_bytes.data[25] == 1;
	return true;
}

Bytes Start::encode() const {
	Bytes made = begin(START, client);
	append(made, cookie);
	append(made, associated());
	append(made, share);
	return made;
}

bool Start::decode(const View &p_bytes) {
	if (!is(p_bytes, START, START_SIZE)) {
		return false;
	}
	client = read_array<8>(p_bytes.data + 1);
	cookie = read_array<16>(p_bytes.data + 9);
	version = read_u32(p_bytes.data + 25);
	role = p_bytes.data[29];
	return_tag = read_array<16>(p_bytes.data + 30);
	share = read_array<32>(p_bytes.data + 46);
	return role < ROLES;
}

Bytes Start::associated() const {
	Bytes made;
	append_u32(made, version);
	made.push_back(role);
	append(made, return_tag);
	return made;
}

Bytes Reply::encode() const {
	Bytes made = begin(REPLY, client);
	append(made, share);
	return made;
}

bool Reply::decode(const View &p_bytes) {
	if (!is(p_bytes, REPLY, REPLY_SIZE)) {
		return false;
	}
	client = read_array<8>(p_bytes.data + 1);
	share = read_array<32>(p_bytes.data + 9);
	return true;
}

Bytes NoticeMessage::encode() const {
	Bytes made = begin(NOTICE, client);
	made.push_back(uint8_t(what));
	append_u32(made, version);
	return made;
}

bool NoticeMessage::decode(const View &p_bytes) {
	if (!is(p_bytes, NOTICE, NOTICE_SIZE)) {
		return false;
	}
	client = read_array<8>(p_bytes.data + 1);
	what = Notice(p_bytes.data[9]);
	version = read_u32(p_bytes.data + 10);
	return what >= Notice::WRONG_PASSWORD && what <= Notice::SERVER_SEALS;
}

Bytes UnknownMessage::encode() const {
	Bytes made{ UNKNOWN };
	append(made, echo);
	append(made, cookie);
	return made;
}

bool UnknownMessage::decode(const View &p_bytes) {
	if (!is(p_bytes, UNKNOWN, UNKNOWN_SIZE)) {
		return false;
	}
	echo = read_array<4>(p_bytes.data + 1);
	cookie = read_array<12>(p_bytes.data + 5);
	return true;
}

Bytes channel_identifier() {
	Bytes made;
	append_text(made, "Dismount client");
	append_text(made, "Dismount server");
	return made;
}

Bytes session_identifier(const ClientId &p_client, const Cookie &p_cookie) {
	Bytes made(p_client.begin(), p_client.end());
	append(made, p_cookie);
	return made;
}

Bytes first_head(const ClientId &p_client) {
	return begin(FIRST, p_client);
}

Bytes moved_head(const ClientId &p_client, const AddressCookie &p_cookie) {
	Bytes made = begin(MOVED, p_client);
	append(made, p_cookie);
	return made;
}

Echo echo_of(const View &p_datagram) {
	return read_array<4>(p_datagram.data + p_datagram.size - 4);
}

} // namespace transport::messages
