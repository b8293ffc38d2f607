// SPDX-License-Identifier: MIT
#include "sealed_channel.hpp"

#include <sodium.h>

namespace transport {

namespace {

static_assert(crypto_aead_chacha20poly1305_IETF_KEYBYTES == 32);
static_assert(crypto_aead_chacha20poly1305_IETF_NPUBBYTES == 12);
static_assert(crypto_aead_chacha20poly1305_IETF_ABYTES == SealedChannel::TAG_SIZE);
static_assert(crypto_generichash_KEYBYTES_MAX == 64);

constexpr uint64_t NUMBERS_SENT = uint64_t(1) << (8 * SealedChannel::NUMBER_SIZE);

Key derive_one(const std::array<uint8_t, 64> &p_session_key, const char *p_label) {
	Key made{};
	crypto_generichash(made.data(), made.size(), reinterpret_cast<const uint8_t *>(p_label), std::strlen(p_label),
			p_session_key.data(), p_session_key.size());
	return made;
}

std::array<uint8_t, 12> nonce_of(uint64_t p_number) {
	std::array<uint8_t, 12> nonce{};
	for (size_t i = 0; i < 8; i++) {
		nonce[4 + i] = uint8_t(p_number >> (8 * i));
	}
	return nonce;
}

} // namespace

ChannelKeys ChannelKeys::derive(const std::array<uint8_t, 64> &p_session_key) {
	ChannelKeys made;
	made.to_server = derive_one(p_session_key, "dismount client to server");
	made.to_client = derive_one(p_session_key, "dismount server to client");
	made.exporter = derive_one(p_session_key, "dismount exporter");
	const Key tag = derive_one(p_session_key, "dismount return");
	std::memcpy(made.return_tag.data(), tag.data(), made.return_tag.size());
	return made;
}

uint64_t SealedChannel::whole_number(uint64_t p_expected, uint64_t p_low) {
	const uint64_t near = (p_expected & ~(NUMBERS_SENT - 1)) | p_low;
	if (near + NUMBERS_SENT / 2 <= p_expected) {
		return near + NUMBERS_SENT;
	}
	if (near > p_expected + NUMBERS_SENT / 2 && near >= NUMBERS_SENT) {
		return near - NUMBERS_SENT;
	}
	return near;
}

void SealedChannel::seal(const View &p_head, const View &p_plain, Bytes &r_sealed) {
	const size_t head_size = p_head.size + NUMBER_SIZE;
	r_sealed.resize(head_size + p_plain.size + TAG_SIZE);
	std::memcpy(r_sealed.data(), p_head.data, p_head.size);
	for (size_t i = 0; i < NUMBER_SIZE; i++) {
		r_sealed[p_head.size + i] = uint8_t(_next_number >> (8 * i));
	}
	const auto nonce = nonce_of(_next_number++);
	crypto_aead_chacha20poly1305_ietf_encrypt(r_sealed.data() + head_size, nullptr, p_plain.data, p_plain.size,
			r_sealed.data(), head_size, nullptr, nonce.data(), _sending.data());
}

bool SealedChannel::open(const View &p_sealed, size_t p_head_size, Bytes &r_plain) {
	const size_t head_size = p_head_size + NUMBER_SIZE;
	if (p_sealed.size < head_size + TAG_SIZE) {
		return false;
	}
	uint64_t low = 0;
	for (size_t i = 0; i < NUMBER_SIZE; i++) {
		low |= uint64_t(p_sealed.data[p_head_size + i]) << (8 * i);
	}
	const uint64_t number = whole_number(_come.next(), low);
	if (!_come.is_new(number)) {
		return false;
	}
	const auto nonce = nonce_of(number);
	r_plain.resize(p_sealed.size - head_size - TAG_SIZE);
	if (crypto_aead_chacha20poly1305_ietf_decrypt(r_plain.data(), nullptr, nullptr, p_sealed.data + head_size,
				p_sealed.size - head_size, p_sealed.data, head_size, nonce.data(), _receiving.data()) != 0) {
		return false;
	}
	_come.note(number);
	return true;
}

} // namespace transport
