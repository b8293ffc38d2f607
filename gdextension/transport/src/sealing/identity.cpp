// SPDX-License-Identifier: MIT
#include "identity.hpp"

#include <algorithm>
#include <cstdlib>
#include <sodium.h>

namespace transport {

namespace {

static_assert(crypto_sign_PUBLICKEYBYTES == 32 && crypto_sign_SEEDBYTES == 32);
static_assert(crypto_sign_SECRETKEYBYTES == 64 && crypto_sign_BYTES == 64);

constexpr char LABEL[] = "dismount server identity";

Bytes signed_text(const Key &p_exporter) {
	Bytes made(LABEL, LABEL + sizeof(LABEL) - 1);
	made.insert(made.end(), p_exporter.begin(), p_exporter.end());
	return made;
}

} // namespace

Identity::Identity() {
	if (sodium_init() < 0 || crypto_sign_keypair(_public.data(), _secret.data()) != 0) {
		std::abort();
	}
}

Identity::Identity(const Key &p_seed) {
	if (sodium_init() < 0 || crypto_sign_seed_keypair(_public.data(), _secret.data(), p_seed.data()) != 0) {
		std::abort();
	}
}

Bytes Identity::prove(const Key &p_exporter) const {
	const Bytes text = signed_text(p_exporter);
	Bytes proof(PROOF_SIZE);
	std::copy(_public.begin(), _public.end(), proof.begin());
	crypto_sign_detached(proof.data() + _public.size(), nullptr, text.data(), text.size(), _secret.data());
	return proof;
}

bool Identity::check(const View &p_proof, const Key &p_exporter, Key &r_key) {
	if (p_proof.size != PROOF_SIZE) {
		return false;
	}
	const Bytes text = signed_text(p_exporter);
	if (crypto_sign_verify_detached(p_proof.data + r_key.size(), text.data(), text.size(), p_proof.data) != 0) {
		return false;
	}
	std::copy_n(p_proof.data, r_key.size(), r_key.begin());
	return true;
}

} // namespace transport
