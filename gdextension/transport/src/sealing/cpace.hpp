// SPDX-License-Identifier: MIT
#pragma once

#include "bytes.hpp"

#include <optional>

namespace transport {

/// CPace (draft-irtf-cfrg-cpace), a balanced key exchange from a password: the suite
/// CPACE-RISTR255-SHA512 in the setting of initiator and responder. Who listens, or takes part without
/// the password, can test one guess in each exchange and none afterwards. All arithmetic is libsodium's.
namespace cpace {

using Share = std::array<uint8_t, 32>;
using Scalar = std::array<uint8_t, 32>;
using Generator = std::array<uint8_t, 32>;
/// The intermediate session key: keys are derived from it, it is not used as one.
using SessionKey = std::array<uint8_t, 64>;

/// Inputs on which both ends must agree.
struct Inputs {
	/// The password; empty for an exchange that authenticates nobody.
	View password;
	/// The channel's identifier.
	View channel;
	/// The session's identifier, which both ends have made unique.
	View session;
};

/// What one end sends.
struct Message {
	Share share{};
	View associated;
};

/// lv_cat() of the draft for one more string: its length as LEB128, then the string.
void append_with_length(Bytes &r_bytes, const View &p_string);
/// The string that generator() hashes.
Bytes generator_string(const Inputs &p_inputs);
/// The encoded generator.
Generator generator(const Inputs &p_inputs);
/// A secret scalar.
Scalar sample_scalar();
/// The share to send; none where the scalar is 0.
std::optional<Share> share_of(const Scalar &p_scalar, const Generator &p_generator);
/// The session key; none where the other end's share is invalid: then the exchange is over.
std::optional<SessionKey> session_key(const Scalar &p_scalar, const Share &p_other, const View &p_session,
		const Message &p_initiator, const Message &p_responder);

} // namespace cpace

} // namespace transport
