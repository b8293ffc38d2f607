// SPDX-License-Identifier: MIT
#pragma once

#include "../sealing/bytes.hpp"
#include "endpoint.hpp"

namespace transport {

/// Where a relay's datagrams go. The bytes are valid during the call.
class RelaySink {
public:
	virtual ~RelaySink() = default;
	/// To the network.
	virtual void to_outer(const Endpoint &p_to, const View &p_bytes) = 0;
	/// To ENet, from a loopback address that stands for the other end, as a number.
	virtual void to_inner(uint32_t p_from, const View &p_bytes) = 0;
	/// A message beside ENet, from a client that was named: see ServerRelay::name.
	virtual void to_program(int64_t p_peer, const View &p_bytes) = 0;
};

} // namespace transport
