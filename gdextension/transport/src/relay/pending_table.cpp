// SPDX-License-Identifier: MIT
#include "pending_table.hpp"

namespace transport {

Pending *PendingTable::find(const Endpoint &p_from) {
	const auto found = _by_endpoint.find(p_from);
	return found != _by_endpoint.end() ? &*found->second : nullptr;
}

Pending &PendingTable::add(const Endpoint &p_from) {
	remove(p_from);
	const Network network = network_of(p_from);
	make_room(network);
	_in_order.emplace_back();
	_in_order.back().from = p_from;
	_by_endpoint[p_from] = std::prev(_in_order.end());
	_of_network[network]++;
	return _in_order.back();
}

void PendingTable::remove(const Endpoint &p_from) {
	const auto found = _by_endpoint.find(p_from);
	if (found != _by_endpoint.end()) {
		remove_at(found->second);
	}
}

void PendingTable::look_after(int64_t p_now_usec) {
	while (!_in_order.empty() && p_now_usec - _in_order.front().since_usec > KEPT_USEC) {
		remove_at(_in_order.begin());
	}
}

void PendingTable::remove_at(Place p_place) {
	const auto network = _of_network.find(network_of(p_place->from));
	if (--network->second == 0) {
		_of_network.erase(network);
	}
	_by_endpoint.erase(p_place->from);
	_in_order.erase(p_place);
}

void PendingTable::make_room(const Network &p_network) {
	const auto of_network = _of_network.find(p_network);
	if (of_network != _of_network.end() && of_network->second >= MAX_OF_NETWORK) {
		for (auto one = _in_order.begin(); one != _in_order.end(); ++one) {
			if (network_of(one->from) == p_network) {
				remove_at(one);
				break;
			}
		}
	}
	if (_in_order.size() >= MAX) {
		remove_at(_in_order.begin());
	}
}

} // namespace transport
