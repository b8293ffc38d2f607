// SPDX-License-Identifier: MIT
#include "relay_socket.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/sock_diag.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace transport {

namespace {

constexpr size_t BATCH = 64;
/// Larger datagrams are no ENet's: they are cut, and dropped.
constexpr size_t BUFFER = 4200;
/// The kernel gives what it allows.
constexpr int BUFFER_BYTES = 2 << 20;
constexpr uint32_t LOOPBACK = 0x7F000001;

sockaddr_in v4(uint32_t p_address, uint16_t p_port) {
	sockaddr_in made{};
	made.sin_family = AF_INET;
	made.sin_port = htons(p_port);
	made.sin_addr.s_addr = htonl(p_address);
	return made;
}

socklen_t write_address(const Endpoint &p_endpoint, bool p_v6, sockaddr_storage &r_address) {
	if (!p_v6) {
		uint32_t address = 0;
		std::memcpy(&address, p_endpoint.address.data() + 12, 4);
		const sockaddr_in made = v4(ntohl(address), p_endpoint.port);
		std::memcpy(&r_address, &made, sizeof(made));
		return sizeof(made);
	}
	sockaddr_in6 made{};
	made.sin6_family = AF_INET6;
	made.sin6_port = htons(p_endpoint.port);
	made.sin6_scope_id = p_endpoint.scope;
	std::memcpy(&made.sin6_addr, p_endpoint.address.data(), 16);
	std::memcpy(&r_address, &made, sizeof(made));
	return sizeof(made);
}

Endpoint read_address(const sockaddr_storage &p_address) {
	Endpoint made;
	if (p_address.ss_family == AF_INET6) {
		const auto &from = reinterpret_cast<const sockaddr_in6 &>(p_address);
		std::memcpy(made.address.data(), &from.sin6_addr, 16);
		made.port = ntohs(from.sin6_port);
		made.scope = from.sin6_scope_id;
	} else {
		const auto &from = reinterpret_cast<const sockaddr_in &>(p_address);
		made.address[10] = made.address[11] = 0xFF;
		std::memcpy(made.address.data() + 12, &from.sin_addr, 4);
		made.port = ntohs(from.sin_port);
	}
	return made;
}

uint16_t port_of(int p_socket) {
	sockaddr_storage at{};
	socklen_t size = sizeof(at);
	return getsockname(p_socket, reinterpret_cast<sockaddr *>(&at), &size) == 0 ? read_address(at).port : 0;
}

int open_udp(int p_family) {
	const int made = socket(p_family, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
	if (made >= 0) {
		for (const int option : { SO_RCVBUF, SO_SNDBUF }) {
			setsockopt(made, SOL_SOCKET, option, &BUFFER_BYTES, sizeof(BUFFER_BYTES));
		}
		// Never cut: many networks drop the pieces. What fits is found out, see PathMtu.
		const int whole = IP_PMTUDISC_PROBE;
		setsockopt(made, IPPROTO_IP, IP_MTU_DISCOVER, &whole, sizeof(whole));
		if (p_family == AF_INET6) {
			const int off = 0;
			setsockopt(made, IPPROTO_IPV6, IPV6_V6ONLY, &off, sizeof(off));
			setsockopt(made, IPPROTO_IPV6, IPV6_MTU_DISCOVER, &whole, sizeof(whole));
		}
	}
	return made;
}

/// A socket that hears one address only, the kernel drops what others send; -1 and errno if there is none.
int open_connected(const Endpoint &p_to) {
	const bool v6 = !is_v4(p_to.address);
	const int made = open_udp(v6 ? AF_INET6 : AF_INET);
	sockaddr_storage address{};
	const socklen_t size = write_address(p_to, v6, address);
	if (made >= 0 && connect(made, reinterpret_cast<const sockaddr *>(&address), size) != 0) {
		const int error = errno;
		::close(made);
		errno = error;
		return -1;
	}
	return made;
}

/// The local address of a socket, without its port.
Endpoint address_of(int p_socket) {
	sockaddr_storage at{};
	socklen_t size = sizeof(at);
	Endpoint made;
	if (getsockname(p_socket, reinterpret_cast<sockaddr *>(&at), &size) == 0) {
		made = read_address(at);
		made.port = 0;
	}
	return made;
}

/// Lets the kernel number no datagrams: on loopback none is ever cut, and numbers cost.
void never_cut(int p_socket) {
	const int never = IP_PMTUDISC_DO;
	setsockopt(p_socket, IPPROTO_IP, IP_MTU_DISCOVER, &never, sizeof(never));
}

/// Lets a socket take only IPv4 datagrams from one port, and from addresses that begin like this one.
bool take_only(int p_socket, uint16_t p_port, uint32_t p_address, uint32_t p_mask) {
	sock_filter code[] = {
		BPF_STMT(BPF_LD | BPF_B | BPF_ABS, uint32_t(SKF_NET_OFF)),
		BPF_STMT(BPF_ALU | BPF_RSH | BPF_K, 4),
		BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, 4, 0, 6),
		BPF_STMT(BPF_LD | BPF_H | BPF_ABS, 0),
		BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, p_port, 0, 4),
		BPF_STMT(BPF_LD | BPF_W | BPF_ABS, uint32_t(SKF_NET_OFF) + 12),
		BPF_STMT(BPF_ALU | BPF_AND | BPF_K, p_mask),
		BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, p_address & p_mask, 0, 1),
		BPF_STMT(BPF_RET | BPF_K, 0xFFFFFFFF),
		BPF_STMT(BPF_RET | BPF_K, 0),
	};
	const sock_fprog program{ uint16_t(std::size(code)), code };
	return setsockopt(p_socket, SOL_SOCKET, SO_ATTACH_FILTER, &program, sizeof(program)) == 0;
}

} // namespace

/// Messages for recvmmsg() and sendmmsg(), made once.
struct RelaySocket::Batch {
	std::array<std::array<uint8_t, BUFFER>, BATCH> buffers;
	std::array<sockaddr_storage, BATCH> addresses{};
	std::array<std::array<uint8_t, CMSG_SPACE(sizeof(in_pktinfo))>, BATCH> controls{};
	std::array<iovec, BATCH> vectors{};
	std::array<mmsghdr, BATCH> messages{};
	size_t used = 0;

	Batch() {
		for (size_t i = 0; i < BATCH; i++) {
			messages[i].msg_hdr.msg_iov = &vectors[i];
			messages[i].msg_hdr.msg_iovlen = 1;
			messages[i].msg_hdr.msg_name = &addresses[i];
		}
	}

	/// Receives; returns how many datagrams.
	size_t receive(int p_socket, size_t p_max, bool p_control) {
		for (size_t i = 0; i < p_max; i++) {
			vectors[i] = { buffers[i].data(), BUFFER };
			msghdr &head = messages[i].msg_hdr;
			head.msg_namelen = sizeof(sockaddr_storage);
			head.msg_control = p_control ? controls[i].data() : nullptr;
			head.msg_controllen = p_control ? controls[i].size() : 0;
		}
		const int count = recvmmsg(p_socket, messages.data(), unsigned(p_max), MSG_DONTWAIT, nullptr);
		return count > 0 ? size_t(count) : 0;
	}

	View bytes(size_t p_index) const {
		const mmsghdr &message = messages[p_index];
		const bool cut = message.msg_hdr.msg_flags & MSG_TRUNC;
		return { buffers[p_index].data(), cut ? 0 : message.msg_len };
	}

	/// The next message to fill with these bytes.
	msghdr &add(const View &p_bytes) {
		const size_t size = std::min(p_bytes.size, BUFFER);
		std::memcpy(buffers[used].data(), p_bytes.data, size);
		vectors[used] = { buffers[used].data(), size };
		msghdr &head = messages[used].msg_hdr;
		head.msg_control = nullptr;
		head.msg_controllen = 0;
		return head;
	}

	void send(int p_socket) {
		size_t begin = 0;
		// One that cannot be sent is skipped: the network loses datagrams, too.
		while (begin < used) {
			const int count = sendmmsg(p_socket, messages.data() + begin, unsigned(used - begin), MSG_DONTWAIT);
			begin += count > 0 ? size_t(count) : 1;
		}
		used = 0;
	}
};

RelaySocket::RelaySocket() :
		_reading(std::make_unique<Batch>()),
		_to_outer(std::make_unique<Batch>()),
		_to_inner(std::make_unique<Batch>()) {}

RelaySocket::~RelaySocket() {
	close();
}

int RelaySocket::open_server(const std::string &p_address, uint16_t p_port) {
	close(_outer);
	Endpoint at;
	const bool any = p_address == "*" || p_address.empty();
	if (!any && !at.parse(p_address, p_port)) {
		return EINVAL;
	}
	at.port = p_port;
	_outer = open_udp(AF_INET6);
	_outer_v6 = _outer >= 0;
	if (!_outer_v6) {
		_outer = open_udp(AF_INET);
	}
	sockaddr_storage address{};
	const socklen_t size = write_address(at, _outer_v6, address);
	if (_outer < 0 || bind(_outer, reinterpret_cast<const sockaddr *>(&address), size) != 0) {
		return errno;
	}
	return 0;
}

int RelaySocket::open_client(const Endpoint &p_server) {
	close(_outer);
	_outer_v6 = !is_v4(p_server.address);
	_outer = open_connected(p_server);
	_connected = _outer >= 0;
	return _connected ? 0 : errno;
}

bool RelaySocket::follow_route(const Endpoint &p_server) {
	int fresh = open_connected(p_server);
	const bool is_other = fresh >= 0 && !(address_of(fresh) == address_of(_outer));
	// The descriptor stays, as others watch it.
	const bool has_followed = is_other && dup3(fresh, _outer, O_CLOEXEC) == _outer;
	close(fresh);
	return has_followed;
}

bool RelaySocket::tie(int p_enet, uint16_t p_enet_port) {
	close(_inner);
	_inner = open_udp(AF_INET);
	const int on = 1;
	const sockaddr_in any = v4(INADDR_ANY, 0);
	_enet = p_enet;
	_enet_port = p_enet_port;
	never_cut(_inner);
	never_cut(p_enet);
	return _inner >= 0 && setsockopt(_inner, IPPROTO_IP, IP_PKTINFO, &on, sizeof(on)) == 0 &&
			take_only(_inner, p_enet_port, LOOPBACK, 0xFFFFFFFF) &&
			bind(_inner, reinterpret_cast<const sockaddr *>(&any), sizeof(any)) == 0 &&
			take_only(p_enet, port_of(_inner), LOOPBACK, 0xFF000000);
}

void RelaySocket::close(int &r_descriptor) {
	if (r_descriptor >= 0) {
		::close(r_descriptor);
	}
	r_descriptor = -1;
}

void RelaySocket::close() {
	close(_outer);
	close(_inner);
	_enet = -1;
	_connected = false;
	_to_outer->used = 0;
	_to_inner->used = 0;
}

int RelaySocket::outer() const {
	return _outer;
}

uint16_t RelaySocket::outer_port() const {
	return port_of(_outer);
}

uint16_t RelaySocket::inner_port() const {
	return port_of(_inner);
}

size_t RelaySocket::read_outer(size_t p_max, const TakeOuter &p_take) {
	size_t read = 0;
	while (read < p_max) {
		const size_t count = _reading->receive(_outer, BATCH, false);
		for (size_t i = 0; i < count; i++) {
			p_take(read_address(_reading->addresses[i]), _reading->bytes(i));
		}
		read += count;
		if (count < BATCH) {
			break;
		}
	}
	return read;
}

size_t RelaySocket::read_inner(const TakeInner &p_take) {
	size_t read = 0;
	for (size_t count = BATCH; count == BATCH;) {
		count = _reading->receive(_inner, BATCH, true);
		for (size_t i = 0; i < count; i++) {
			msghdr &head = _reading->messages[i].msg_hdr;
			for (cmsghdr *one = CMSG_FIRSTHDR(&head); one != nullptr; one = CMSG_NXTHDR(&head, one)) {
				if (one->cmsg_level == IPPROTO_IP && one->cmsg_type == IP_PKTINFO) {
					in_pktinfo info{};
					std::memcpy(&info, CMSG_DATA(one), sizeof(info));
					p_take(ntohl(info.ipi_addr.s_addr), _reading->bytes(i));
				}
			}
		}
		read += count;
	}
	return read;
}

void RelaySocket::write_outer(const Endpoint &p_to, const View &p_bytes) {
	msghdr &head = _to_outer->add(p_bytes);
	auto &address = _to_outer->addresses[_to_outer->used];
	head.msg_name = _connected ? nullptr : &address;
	head.msg_namelen = _connected ? 0 : write_address(p_to, _outer_v6, address);
	if (++_to_outer->used == BATCH) {
		_to_outer->send(_outer);
	}
}

void RelaySocket::write_inner(uint32_t p_from, const View &p_bytes) {
	msghdr &head = _to_inner->add(p_bytes);
	const size_t index = _to_inner->used;
	const sockaddr_in to = v4(LOOPBACK, _enet_port);
	std::memcpy(&_to_inner->addresses[index], &to, sizeof(to));
	head.msg_namelen = sizeof(to);
	head.msg_control = _to_inner->controls[index].data();
	head.msg_controllen = _to_inner->controls[index].size();
	cmsghdr *control = CMSG_FIRSTHDR(&head);
	control->cmsg_level = IPPROTO_IP;
	control->cmsg_type = IP_PKTINFO;
	control->cmsg_len = CMSG_LEN(sizeof(in_pktinfo));
	in_pktinfo info{};
	info.ipi_spec_dst.s_addr = htonl(p_from);
	std::memcpy(CMSG_DATA(control), &info, sizeof(info));
	if (++_to_inner->used == BATCH) {
		_to_inner->send(_inner);
	}
}

void RelaySocket::flush() {
	_to_outer->send(_outer);
	_to_inner->send(_inner);
}

bool RelaySocket::has_room() const {
	std::array<uint32_t, SK_MEMINFO_VARS> memory{};
	socklen_t size = sizeof(memory);
	if (getsockopt(_enet, SOL_SOCKET, SO_MEMINFO, memory.data(), &size) != 0) {
		return true;
	}
	return memory[SK_MEMINFO_RMEM_ALLOC] < memory[SK_MEMINFO_RCVBUF] / 2;
}

} // namespace transport
