// SPDX-License-Identifier: MIT
#pragma once

#include "sealed_channel.hpp"

namespace transport {

/// A server's key pair (Ed25519), and what proves it to a client: the public key and a signature that
/// is bound to one handshake, so that nobody in the middle can pass it on.
class Identity {
public:
	static constexpr size_t PROOF_SIZE = 32 + 64;

	/// A fresh one.
	Identity();
	explicit Identity(const Key &p_seed);

	const Key &public_key() const { return _public; }
	/// For the handshake with this exporter key.
	Bytes prove(const Key &p_exporter) const;
	/// Whether these bytes prove a key for the handshake with this exporter key; it is put into r_key.
	static bool check(const View &p_proof, const Key &p_exporter, Key &r_key);

private:
	std::array<uint8_t, 64> _secret{};
	Key _public{};
};

} // namespace transport
