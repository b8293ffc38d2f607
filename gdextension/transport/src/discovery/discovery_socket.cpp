// SPDX-License-Identifier: MIT
#include "discovery_socket.hpp"

#include <cerrno>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sodium.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

namespace transport {

namespace {

constexpr int BUFFER_BYTES = 1 << 20;
constexpr size_t V4_AT = 12;
/// All nodes of a link, ff02::1.
constexpr std::array<uint8_t, 16> ALL_NODES{ { 0xFF, 0x02, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1 } };

/// Time of the clock that the kernel stamps datagrams with, us.
int64_t stamp_usec() {
	timespec now{};
	clock_gettime(CLOCK_REALTIME, &now);
	return int64_t(now.tv_sec) * 1000000 + now.tv_nsec / 1000;
}

int open_udp(int p_family) {
	const int made = socket(p_family, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
	if (made < 0) {
		return made;
	}
	const int on = 1;
	setsockopt(made, SOL_SOCKET, SO_RCVBUF, &BUFFER_BYTES, sizeof(BUFFER_BYTES));
	setsockopt(made, SOL_SOCKET, SO_TIMESTAMP, &on, sizeof(on));
	if (p_family == AF_INET6) {
		setsockopt(made, IPPROTO_IPV6, IPV6_V6ONLY, &on, sizeof(on));
	} else {
		setsockopt(made, SOL_SOCKET, SO_BROADCAST, &on, sizeof(on));
	}
	return made;
}

sockaddr_in v4_of(const Endpoint &p_endpoint) {
	sockaddr_in made{};
	made.sin_family = AF_INET;
	made.sin_port = htons(p_endpoint.port);
	std::memcpy(&made.sin_addr, p_endpoint.address.data() + V4_AT, sizeof(made.sin_addr));
	return made;
}

sockaddr_in6 v6_of(const Endpoint &p_endpoint) {
	sockaddr_in6 made{};
	made.sin6_family = AF_INET6;
	made.sin6_port = htons(p_endpoint.port);
	made.sin6_scope_id = p_endpoint.scope;
	std::memcpy(&made.sin6_addr, p_endpoint.address.data(), sizeof(made.sin6_addr));
	return made;
}

Endpoint endpoint_of(const in_addr &p_address, uint16_t p_port) {
	Endpoint made;
	made.address[10] = made.address[11] = 0xFF;
	std::memcpy(made.address.data() + V4_AT, &p_address, sizeof(p_address));
	made.port = p_port;
	return made;
}

Endpoint sender_of(const sockaddr_storage &p_from) {
	if (p_from.ss_family == AF_INET) {
		const auto &v4 = reinterpret_cast<const sockaddr_in &>(p_from);
		return endpoint_of(v4.sin_addr, ntohs(v4.sin_port));
	}
	const auto &v6 = reinterpret_cast<const sockaddr_in6 &>(p_from);
	Endpoint made;
	std::memcpy(made.address.data(), &v6.sin6_addr, sizeof(v6.sin6_addr));
	made.port = ntohs(v6.sin6_port);
	made.scope = v6.sin6_scope_id;
	return made;
}

/// When the kernel has received a datagram.
int64_t arrival_of(msghdr &p_head) {
	for (cmsghdr *one = CMSG_FIRSTHDR(&p_head); one != nullptr; one = CMSG_NXTHDR(&p_head, one)) {
		if (one->cmsg_level == SOL_SOCKET && one->cmsg_type == SCM_TIMESTAMP) {
			timeval stamp{};
			std::memcpy(&stamp, CMSG_DATA(one), sizeof(stamp));
			return int64_t(stamp.tv_sec) * 1000000 + stamp.tv_usec;
		}
	}
	return stamp_usec();
}

} // namespace

bool DiscoverySocket::open() {
	close();
	_v4 = open_udp(AF_INET);
	_v6 = open_udp(AF_INET6);
	return _v4 >= 0 || _v6 >= 0;
}

void DiscoverySocket::close() {
	for (int *descriptor : { &_v4, &_v6 }) {
		if (*descriptor >= 0) {
			::close(*descriptor);
		}
		*descriptor = -1;
	}
	_open = OpenQuestions();
}

bool DiscoverySocket::ask(const Endpoint &p_to, bool p_to_all) {
	discovery::Nonce nonce;
	randombytes_buf(nonce.data(), nonce.size());
	const Bytes question = discovery::make_question(nonce);
	const int64_t now_usec = stamp_usec();
	ssize_t sent = 0;
	if (is_v4(p_to.address)) {
		const sockaddr_in to = v4_of(p_to);
		const auto *address = reinterpret_cast<const sockaddr *>(&to);
		sent = sendto(_v4, question.data(), question.size(), MSG_DONTWAIT, address, sizeof(to));
	} else {
		const sockaddr_in6 to = v6_of(p_to);
		const auto *address = reinterpret_cast<const sockaddr *>(&to);
		sent = sendto(_v6, question.data(), question.size(), MSG_DONTWAIT, address, sizeof(to));
	}
	if (sent == ssize_t(question.size())) {
		_open.note(nonce, p_to, !p_to_all, now_usec);
	}
	return sent == ssize_t(question.size());
}

size_t DiscoverySocket::take(size_t p_max, const Take &p_take) {
	const size_t of_v4 = take_from(_v4, p_max, p_take);
	return of_v4 + take_from(_v6, p_max - of_v4, p_take);
}

size_t DiscoverySocket::take_from(int p_socket, size_t p_max, const Take &p_take) {
	std::array<uint8_t, discovery::QUESTION_SIZE + 1> buffer;
	std::array<uint8_t, CMSG_SPACE(sizeof(timeval))> control;
	size_t read = 0;
	while (p_socket >= 0 && read < p_max) {
		sockaddr_storage from{};
		iovec part{ buffer.data(), buffer.size() };
		msghdr head{};
		head.msg_name = &from;
		head.msg_namelen = sizeof(from);
		head.msg_iov = &part;
		head.msg_iovlen = 1;
		head.msg_control = control.data();
		head.msg_controllen = control.size();
		const ssize_t size = recvmsg(p_socket, &head, MSG_DONTWAIT);
		if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
			break;
		}
		read++;
		if (size < 0) {
			continue;
		}
		const View bytes(buffer.data(), size_t(size));
		const Endpoint sender = sender_of(from);
		const int64_t delay_usec = _open.take(bytes, sender, arrival_of(head));
		if (delay_usec >= 0) {
			p_take(sender, bytes.from(discovery::ANSWER_HEAD), delay_usec);
		}
	}
	return read;
}

std::vector<Endpoint> DiscoverySocket::neighbours() {
	std::vector<Endpoint> made;
	ifaddrs *first = nullptr;
	if (getifaddrs(&first) != 0) {
		return made;
	}
	for (const ifaddrs *one = first; one != nullptr; one = one->ifa_next) {
		const bool is_up = (one->ifa_flags & IFF_UP) != 0 && (one->ifa_flags & IFF_LOOPBACK) == 0;
		if (!is_up || one->ifa_addr == nullptr) {
			continue;
		}
		if (one->ifa_addr->sa_family == AF_INET && (one->ifa_flags & IFF_BROADCAST) != 0 &&
				one->ifa_broadaddr != nullptr) {
			made.push_back(endpoint_of(reinterpret_cast<const sockaddr_in *>(one->ifa_broadaddr)->sin_addr, 0));
		} else if (one->ifa_addr->sa_family == AF_INET6 && (one->ifa_flags & IFF_MULTICAST) != 0) {
			const auto *own = reinterpret_cast<const sockaddr_in6 *>(one->ifa_addr);
			if (IN6_IS_ADDR_LINKLOCAL(&own->sin6_addr)) {
				Endpoint all;
				all.address = ALL_NODES;
				all.scope = own->sin6_scope_id;
				made.push_back(all);
			}
		}
	}
	freeifaddrs(first);
	return made;
}

} // namespace transport
