// SPDX-License-Identifier: MIT
#include "discovery_messages.hpp"

namespace transport::discovery {

namespace {

constexpr std::array<uint8_t, 4> MAGIC{ { 'D', 'S', 'M', 'T' } };
constexpr size_t NONCE_AT = 6;

} // namespace

Bytes make_question(const Nonce &p_nonce) {
	Bytes made{ QUESTION };
	append(made, MAGIC);
	made.push_back(VERSION);
	append(made, p_nonce);
	made.resize(QUESTION_SIZE);
	return made;
}

bool read_question(const View &p_bytes, Nonce &r_nonce) {
	if (p_bytes.size != QUESTION_SIZE || p_bytes.data[0] != QUESTION || read_array<4>(p_bytes.data + 1) != MAGIC) {
		return false;
	}
	r_nonce = read_array<8>(p_bytes.data + NONCE_AT);
	return true;
}

Bytes make_answer(const Nonce &p_nonce, const View &p_body) {
	Bytes made{ ANSWER };
	append(made, p_nonce);
	append(made, p_body);
	return made;
}

bool read_answer(const View &p_bytes, Nonce &r_nonce) {
	if (p_bytes.size < ANSWER_HEAD || p_bytes.size > QUESTION_SIZE || p_bytes.data[0] != ANSWER) {
		return false;
	}
	r_nonce = read_array<8>(p_bytes.data + 1);
	return true;
}

} // namespace transport::discovery
