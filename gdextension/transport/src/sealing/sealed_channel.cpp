// SPDX-License-Identifier: MIT
#include "sealed_channel.hpp"

#include <sodium.h>

namespace transport {

namespace {

static_assert(crypto_aead_chacha20poly1305_IETF_KEYBYTES == 32);
static_assert(crypto_aead_chacha20poly1305_IETF_NPUBBYTES == 12);
static_assert(crypto_aead_chacha20poly1305_IETF_ABYTES == SealedChannel::TAG_SIZE);
static_assert(crypto_generichash_KEYBYTES_MAX == 64);

constexpr uint8_t SEALED = 0x80;
constexpr uint8_t IS_FAST = 0x40;
constexpr size_t LONG_NUMBER_SIZE = 3;

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

uint64_t SealedChannel::whole_number(uint64_t p_expected, uint64_t p_low, int p_bits) {
	const uint64_t sent = uint64_t(1) << p_bits;
	const uint64_t near = (p_expected & ~(sent - 1)) | p_low;
	if (near + sent / 2 <= p_expected) {
		return near + sent;
	}
	if (near > p_expected + sent / 2 && near >= sent) {
		return near - sent;
	}
	return near;
}

void SealedChannel::seal(Content p_content, const View &p_plain, Bytes &r_sealed) {
	r_sealed.resize(HEAD_SIZE);
	r_sealed[0] = SEALED | (p_content == Content::FAST ? IS_FAST : 0) | uint8_t(_next_number >> 8 & 0x3F);
	r_sealed[1] = uint8_t(_next_number);
	encrypt(HEAD_SIZE, p_plain, r_sealed);
}

void SealedChannel::seal(const View &p_head, const View &p_plain, Bytes &r_sealed) {
	r_sealed.assign(p_head.data, p_head.data + p_head.size);
	for (size_t i = 0; i < LONG_NUMBER_SIZE; i++) {
		r_sealed.push_back(uint8_t(_next_number >> (8 * i)));
	}
	encrypt(r_sealed.size(), p_plain, r_sealed);
}

bool SealedChannel::open(const View &p_sealed, Content &r_content, Bytes &r_plain) {
	if (!is_sealed(p_sealed)) {
		return false;
	}
	const uint64_t low = uint64_t(p_sealed.data[0] & 0x3F) << 8 | p_sealed.data[1];
	r_content = (p_sealed.data[0] & IS_FAST) != 0 ? Content::FAST : Content::ENET;
	return decrypt(p_sealed, HEAD_SIZE, whole_number(_come.next(), low, NUMBER_BITS), r_plain);
}

bool SealedChannel::open(const View &p_sealed, size_t p_head_size, Bytes &r_plain) {
	const size_t head_size = p_head_size + LONG_NUMBER_SIZE;
	if (p_sealed.size < head_size + TAG_SIZE) {
		return false;
	}
	uint64_t low = 0;
	for (size_t i = 0; i < LONG_NUMBER_SIZE; i++) {
		low |= uint64_t(p_sealed.data[p_head_size + i]) << (8 * i);
	}
	return decrypt(p_sealed, head_size, whole_number(_come.next(), low, LONG_NUMBER_BITS), r_plain);
}

/// Appends to a head.
void SealedChannel::encrypt(size_t p_head_size, const View &p_plain, Bytes &r_sealed) {
	r_sealed.resize(p_head_size + p_plain.size + TAG_SIZE);
	const auto nonce = nonce_of(_next_number++);
	crypto_aead_chacha20poly1305_ietf_encrypt(r_sealed.data() + p_head_size, nullptr, p_plain.data, p_plain.size,
			r_sealed.data(), p_head_size, nullptr, nonce.data(), _sending.data());
}

bool SealedChannel::decrypt(const View &p_sealed, size_t p_head_size, uint64_t p_number, Bytes &r_plain) {
	if (!_come.is_new(p_number)) {
		return false;
	}
	const auto nonce = nonce_of(p_number);
	r_plain.resize(p_sealed.size - p_head_size - TAG_SIZE);
	if (crypto_aead_chacha20poly1305_ietf_decrypt(r_plain.data(), nullptr, nullptr, p_sealed.data + p_head_size,
				p_sealed.size - p_head_size, p_sealed.data, p_head_size, nonce.data(), _receiving.data()) != 0) {
		return false;
	}
	_come.note(p_number);
	return true;
}

} // namespace transport
