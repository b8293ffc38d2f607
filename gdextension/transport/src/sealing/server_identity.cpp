// SPDX-License-Identifier: MIT
#include "server_identity.hpp"

#include <cstdlib>
#include <sodium.h>

namespace transport {

namespace {

static_assert(crypto_sign_SEEDBYTES == std::tuple_size<ServerIdentity::Seed>::value);
static_assert(crypto_sign_PUBLICKEYBYTES == std::tuple_size<ServerIdentity::PublicKey>::value);
static_assert(crypto_sign_SECRETKEYBYTES == 64);
static_assert(crypto_sign_BYTES == std::tuple_size<ServerIdentity::Signature>::value);

constexpr char LABEL[] = "dismount server identity";

Bytes signed_text(const Key &p_exporter) {
	const auto *label = reinterpret_cast<const uint8_t *>(LABEL);
	Bytes made(label, label + sizeof(LABEL) - 1);
	append(made, p_exporter);
	return made;
}

ServerIdentity::Seed fresh_seed() {
	if (sodium_init() < 0) {
		std::abort();
	}
	ServerIdentity::Seed made{};
	randombytes_buf(made.data(), made.size());
	return made;
}

} // namespace

ServerIdentity::ServerIdentity() : ServerIdentity(fresh_seed()) {}

ServerIdentity::ServerIdentity(const Seed &p_seed) {
	crypto_sign_seed_keypair(_key.data(), _secret.data(), p_seed.data());
}

ServerIdentity::Proof ServerIdentity::prove(const Key &p_exporter) const {
	const Bytes text = signed_text(p_exporter);
	Proof made;
	made.key = _key;
	crypto_sign_detached(made.signature.data(), nullptr, text.data(), text.size(), _secret.data());
	return made;
}

Bytes ServerIdentity::Proof::encode() const {
	Bytes made(key.begin(), key.end());
	append(made, signature);
	return made;
}

bool ServerIdentity::Proof::decode(const View &p_bytes) {
	if (p_bytes.size != key.size() + signature.size()) {
		return false;
	}
	key = read_array<32>(p_bytes.data);
	signature = read_array<64>(p_bytes.data + key.size());
	return true;
}

bool ServerIdentity::Proof::is_of(const Key &p_exporter) const {
	const Bytes text = signed_text(p_exporter);
	return crypto_sign_verify_detached(signature.data(), text.data(), text.size(), key.data()) == 0;
}

} // namespace transport
