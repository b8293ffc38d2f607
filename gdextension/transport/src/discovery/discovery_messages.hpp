// SPDX-License-Identifier: MIT
#pragma once

#include "../sealing/bytes.hpp"

namespace transport::discovery {

/// How a client finds servers: a padded question and an answer that is never longer. Layouts: docs/protocol.md.
/// Their first bytes are none of ENet's and none of the sealing's, see messages::Type.
constexpr uint8_t QUESTION = 0x4B;
constexpr uint8_t ANSWER = 0x4C;
/// Version of the question, not of the protocol: whatever it is, the question is answered.
constexpr uint8_t VERSION = 1;
constexpr size_t QUESTION_SIZE = 512;
constexpr size_t ANSWER_HEAD = 9;
/// What a server may say of itself, so that no answer is longer than its question.
constexpr size_t MAX_BODY = QUESTION_SIZE - ANSWER_HEAD;

/// Chosen by chance for each question: who has not seen it can answer nothing.
using Nonce = std::array<uint8_t, 8>;

Bytes make_question(const Nonce &p_nonce);
/// False if it is no question.
bool read_question(const View &p_bytes, Nonce &r_nonce);
Bytes make_answer(const Nonce &p_nonce, const View &p_body);
/// False if it is no answer; its body begins at ANSWER_HEAD.
bool read_answer(const View &p_bytes, Nonce &r_nonce);

} // namespace transport::discovery
