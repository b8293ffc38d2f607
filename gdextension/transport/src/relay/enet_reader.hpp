// SPDX-License-Identifier: MIT
#pragma once

#include "../sealing/bytes.hpp"

namespace transport {

/// One command of an ENet datagram; only the fields that its kind has are set.
struct EnetCommand {
	enum Kind : uint8_t {
		ACKNOWLEDGE = 1,
		CONNECT,
		VERIFY_CONNECT,
		DISCONNECT,
		PING,
		SEND_RELIABLE,
		SEND_UNRELIABLE,
		SEND_FRAGMENT,
		SEND_UNSEQUENCED,
		BANDWIDTH_LIMIT,
		THROTTLE_CONFIGURE,
		SEND_UNRELIABLE_FRAGMENT,
	};

	Kind kind = PING;
	uint8_t channel = 0;
	/// The command's own number; of an acknowledgement: the number that is acknowledged.
	uint16_t number = 0;
	/// Bytes of what is carried.
	size_t size = 0;
	/// Of a fragment.
	uint16_t first_number = 0;
	uint32_t fragments = 0;
	uint32_t fragment = 0;
	uint32_t whole_size = 0;
	uint32_t offset = 0;
	/// Of CONNECT and VERIFY_CONNECT.
	uint16_t peer = 0;
	uint8_t incoming_session = 0;
	uint8_t outgoing_session = 0;
	uint32_t channels = 0;
	/// Of CONNECT: 8 bytes that the client has chosen by chance, as they came.
	std::array<uint8_t, 8> chosen{};
};

/// Reads an ENet datagram command by command. It comes from the network: what is cut off, too long
/// or of no known kind is a fault.
class EnetReader {
public:
	/// The number of a peer that has none yet.
	static constexpr uint16_t NO_PEER = 0xFFF;

	explicit EnetReader(const View &p_datagram);

	/// Whether the head makes sense. Compressed datagrams do not: nobody here sends them.
	bool is_valid() const { return _valid; }
	/// The peer that it is for, as its receiver counts.
	uint16_t peer() const { return _peer; }
	/// Reads one more. False at the end and at a fault, see is_valid().
	bool next(EnetCommand &r_command);

private:
	bool read_body(EnetCommand &r_command, size_t p_size);

	View _left;
	uint16_t _peer = 0;
	bool _valid = false;
};

/// A datagram that ends the connection of a peer, as the other end would send it.
std::array<uint8_t, 10> make_enet_disconnect(uint16_t p_peer, uint8_t p_session);

} // namespace transport
