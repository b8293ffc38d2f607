// SPDX-License-Identifier: MIT
#include "receipt_window.hpp"

#include <algorithm>
#include <sys/random.h>

namespace transport {

bool ReceiptWindow::note_sent(int64_t p_bytes, Nonce &r_probe) {
	_unreceipted += p_bytes;
	_since_probe += p_bytes;
	if (_since_probe < PROBE_EVERY) {
		return false;
	}
	Probe probe;
	// Without randomness the probe waits for the next packet: a guessed one proves nothing.
	if (getrandom(probe.nonce.data(), probe.nonce.size(), 0) != ssize_t(probe.nonce.size())) {
		return false;
	}
	probe.bytes = _since_probe;
	_since_probe = 0;
	_probes.push_back(probe);
	r_probe = probe.nonce;
	return true;
}

void ReceiptWindow::take_receipt(const Nonce &p_nonce) {
	const auto found = std::find_if(
			_probes.begin(), _probes.end(), [&p_nonce](const Probe &p_probe) { return p_probe.nonce == p_nonce; });
	if (found == _probes.end()) {
		return;
	}
	for (auto probe = _probes.begin(); probe != found + 1; ++probe) {
		_unreceipted -= probe->bytes;
	}
	_probes.erase(_probes.begin(), found + 1);
}

} // namespace transport
