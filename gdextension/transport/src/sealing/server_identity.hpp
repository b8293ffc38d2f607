// SPDX-License-Identifier: MIT
#pragma once

#include "sealed_channel.hpp"

#include <optional>

namespace transport {

/// A server's own key, by which a client knows it again: an Ed25519 key (RFC 8032). It signs what only
/// the two ends of one connection know, so that nobody in between can pass a proof on.
class ServerIdentity {
public:
	using Seed = std::array<uint8_t, 32>;
	using PublicKey = std::array<uint8_t, 32>;
	using Signature = std::array<uint8_t, 64>;

	/// What a server shows.
	struct Proof {
		PublicKey key{};
		Signature signature{};

		Bytes encode() const;
		/// False if it is none.
		bool decode(const View &p_bytes);
		/// Whether the owner of the key has made it for the connection with this exporter.
		bool is_of(const Key &p_exporter) const;
	};

	/// With a fresh key.
	ServerIdentity();
	explicit ServerIdentity(const Seed &p_seed);

	Proof prove(const Key &p_exporter) const;
	const PublicKey &key() const { return _key; }

private:
	PublicKey _key{};
	std::array<uint8_t, 64> _secret{};
};

} // namespace transport
