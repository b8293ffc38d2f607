// SPDX-License-Identifier: MIT
#include "cpace.hpp"

#include <algorithm>
#include <sodium.h>

namespace transport::cpace {

namespace {

constexpr char DSI[] = "CPaceRistretto255";
constexpr char DSI_ISK[] = "CPaceRistretto255_ISK";
/// Input block of SHA-512, bytes.
constexpr size_t HASH_BLOCK = 128;

View ascii(const char *p_text) {
	return { reinterpret_cast<const uint8_t *>(p_text), std::strlen(p_text) };
}

size_t size_with_length(size_t p_size) {
	size_t size = p_size + 1;
	for (size_t left = p_size >> 7; left > 0; left >>= 7) {
		size++;
	}
	return size;
}

std::array<uint8_t, 64> sha512(const Bytes &p_bytes) {
	static_assert(crypto_hash_sha512_BYTES == 64);
	std::array<uint8_t, 64> hash{};
	crypto_hash_sha512(hash.data(), p_bytes.data(), p_bytes.size());
	return hash;
}

} // namespace

void append_with_length(Bytes &r_bytes, const View &p_string) {
	size_t left = p_string.size;
	do {
		const uint8_t more = left > 127 ? 128 : 0;
		r_bytes.push_back(uint8_t(left & 127) | more);
		left >>= 7;
	} while (left > 0);
	append(r_bytes, p_string);
}

Bytes generator_string(const Inputs &p_inputs) {
	const size_t used = 1 + size_with_length(p_inputs.password.size) + size_with_length(sizeof(DSI) - 1);
	const Bytes padding(HASH_BLOCK - std::min(used, HASH_BLOCK), 0);
	Bytes made;
	append_with_length(made, ascii(DSI));
	append_with_length(made, p_inputs.password);
	append_with_length(made, padding);
	append_with_length(made, p_inputs.channel);
	append_with_length(made, p_inputs.session);
	return made;
}

Generator generator(const Inputs &p_inputs) {
	static_assert(crypto_core_ristretto255_HASHBYTES == 64 && crypto_core_ristretto255_BYTES == 32);
	Bytes text = generator_string(p_inputs);
	std::array<uint8_t, 64> hash = sha512(text);
	Generator made{};
	crypto_core_ristretto255_from_hash(made.data(), hash.data());
	sodium_memzero(text.data(), text.size());
	sodium_memzero(hash.data(), hash.size());
	return made;
}

Scalar sample_scalar() {
	static_assert(crypto_core_ristretto255_SCALARBYTES == 32);
	Scalar made{};
	crypto_core_ristretto255_scalar_random(made.data());
	return made;
}

std::optional<Share> share_of(const Scalar &p_scalar, const Generator &p_generator) {
	Share made{};
	if (crypto_scalarmult_ristretto255(made.data(), p_scalar.data(), p_generator.data()) != 0) {
		return std::nullopt;
	}
	return made;
}

std::optional<SessionKey> session_key(const Scalar &p_scalar, const Share &p_other, const View &p_session,
		const Message &p_initiator, const Message &p_responder) {
	// Fails for what encodes no element, and for the neutral one.
	std::optional<Share> secret = share_of(p_scalar, p_other);
	if (!secret) {
		return std::nullopt;
	}
	Bytes text;
	append_with_length(text, ascii(DSI_ISK));
	append_with_length(text, p_session);
	append_with_length(text, *secret);
	for (const Message *message : { &p_initiator, &p_responder }) {
		append_with_length(text, message->share);
		append_with_length(text, message->associated);
	}
	const SessionKey key = sha512(text);
	sodium_memzero(secret->data(), secret->size());
	sodium_memzero(text.data(), text.size());
	return key;
}

} // namespace transport::cpace
